// One more diffuse bounce: every side of a voxel gathers what the hemisphere over it sends, and reflects its share (DVS,
// 'Voxel Global Illumination').

import package::common::attributes::voxel_surface;
import package::common::dispatch::dispatch_index;
import package::common::radiance::pack_radiance;
import package::common::side::{Side, next_side};
import package::common::trace::{hemisphere_lobe, reach_of};
import package::common::share::share_at;
import package::common::voxels::level_cell;
import package::tracer::trace::trace_gather;

var<storage, read_write> bounced: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let surface = voxel_surface(slot);
    let share = share_at(cell.xy ^ cell.zz, 8);
    var at = 0u;
    var side: Side;
    while (next_side(cell, slot, surface, share, &at, &side)) {
        // Irradiance is π times the mean radiance, and what is reflected of it albedo / π.
        let arriving = trace_gather(side.apex, hemisphere_lobe(side.apex.normal), reach_of(1e30)).radiance;
        bounced[side.index] = pack_radiance(side.reflectance * arriving);
    }
}
