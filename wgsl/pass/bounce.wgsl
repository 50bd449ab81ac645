// One more diffuse bounce: every voxel gathers what the hemisphere sends (DVS, 'Voxel Global
// Illumination') and adds what it reflects to its own light.

import package::common::attributes::{voxel_facing, voxel_facings, voxel_surface};
import package::common::constants::PI;
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::common::trace::{hemisphere_lobe, reach_of, voxel_apex};
import package::common::turn::turn_at;
import package::tracer::trace::trace_gather;

// The light that stays from bounce to bounce: direct light and emission.
var<storage, read> direct: array<vec4f>;
var<storage, read_write> bounced: array<vec4f>;

// Without: what is reflected, alone.
override ADD_DIRECT: bool = true;

// Irradiance on one side of a voxel's surface, W·m⁻².
fn irradiance(cell: vec3u, normal: vec3f) -> vec3f {
    let apex = voxel_apex(vec3f(cell) + 0.5, normal, turn_at(cell.xy ^ cell.zz));
    return PI * trace_gather(apex, hemisphere_lobe(normal), reach_of(1e30)).radiance;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let surface = voxel_surface(slot);
    let facings = voxel_facings(surface);
    var arriving = vec3f(0.0);
    for (var i = 0u; i < facings.count; i++) {
        let normal = voxel_facing(surface, facings, i);
        var both = irradiance(cell, normal);
        if (facings.count > 1) {
            both += irradiance(cell, -normal);
        }
        arriving += both / facings.divisor;
    }
    var radiance = surface.albedo / PI * arriving;
    if (ADD_DIRECT) {
        radiance += direct[slot].rgb;
    }
    bounced[slot] = vec4f(radiance, 1.0);
}
