// One more diffuse bounce: every voxel gathers what the hemisphere sends (DVS, 'Voxel Global
// Illumination') and adds what it reflects to its own light.

import package::common::attributes::{voxel_facing, voxel_facings, voxel_surface};
import package::common::diffuse_cones::{DiffuseCones, FULL_RING, gather_diffuse};
import package::common::constants::PI;
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::common::trace::Apex;

struct Params {
    /// Where traces begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
}

var<uniform> params: Params;
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
    let facings = voxel_facings(surface);
    let cones = DiffuseCones(FULL_RING, 0.0);
    let p_voxel = vec3f(cell) + 0.5;
    var arriving = vec3f(0.0);
    for (var i = 0u; i < facings.count; i++) {
        let normal = voxel_facing(surface, facings, i);
        var both = gather_diffuse(Apex(p_voxel, normal, params.start), cones).rgb;
        if (facings.count > 1) {
            both += gather_diffuse(Apex(p_voxel, -normal, params.start), cones).rgb;
        }
        arriving += both / facings.divisor;
    }
    var radiance = surface.albedo / PI * arriving;
    if (ADD_DIRECT) {
        radiance += direct[slot].rgb;
    }
    bounced[slot] = vec4f(radiance, 1.0);
}
