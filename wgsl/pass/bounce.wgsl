// One more diffuse bounce: every voxel gathers what the hemisphere sends (DVS, 'Voxel Global
// Illumination') and adds what it reflects to its own light.

import package::common::attributes::voxel_surface;
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::common::side::SIDES;
import package::common::trace::{hemisphere_lobe, reach_of};
import package::common::turn::turn_at;
import package::meet::side;
import package::tracer::trace::trace_gather;

// The light that stays from bounce to bounce: direct light and emission.
var<storage, read> direct: array<vec4f>;
var<storage, read_write> bounced: array<vec4f>;

// Without: what is reflected, alone.
override ADD_DIRECT: bool = true;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let surface = voxel_surface(slot);
    let turn = turn_at(cell.xy ^ cell.zz);
    var arriving = vec4f(0.0);
    for (var i = 0u; i < SIDES; i++) {
        let of_side = side(cell, slot, surface, i, turn);
        if (of_side.share > 0.0) {
            let found = trace_gather(of_side.apex, hemisphere_lobe(of_side.apex.normal), reach_of(1e30));
            arriving += of_side.share * vec4f(found.radiance, 1.0);
        }
    }
    // Irradiance is π times the mean radiance, and what is reflected of it albedo / π.
    var radiance = surface.albedo * arriving.rgb / max(arriving.a, 1e-6);
    if (ADD_DIRECT) {
        radiance += direct[slot].rgb;
    }
    bounced[slot] = vec4f(radiance, 1.0);
}
