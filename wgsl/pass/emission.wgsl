// What emissive surfaces emit, alone: the first volume, from which voxels gather their light, and past which the
// sky's, once.

import package::common::attributes::voxel_surface;
import package::common::dispatch::dispatch_index;
import package::common::radiance::pack_radiance;
import package::common::side::{Side, next_side};
import package::common::trace::WHOLE;
import package::common::voxels::level_cell;
import package::emitters::SAMPLED;

var<storage, read_write> direct: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (level_cell(slot, 0, &cell)) {
        let surface = voxel_surface(slot);
        var at = 0u;
        var side: Side;
        while (next_side(cell, slot, surface, WHOLE, &at, &side)) {
            direct[side.index] = pack_radiance(select(side.emission, vec3f(0.0), SAMPLED));
        }
    }
}
