// One more diffuse bounce: every voxel gathers the volume through the diffuse cones (DVS, 'Voxel Global
// Illumination') and adds what it reflects to its own light.

import package::common::attributes::voxel_surface;
import package::common::diffuse_cones::{DiffuseCones, FULL_RING, gather_diffuse};
import package::common::constants::PI;
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::common::cone::ConeSettings;

struct Params {
    /// 1: tangent spheres; 2: the 60° doubling cone.
    stepper: u32,
    /// Step over cell size, of the tangent spheres, (0, 1].
    step: f32,
    /// Where cones begin: 1 is where the surface's own voxels end, [0, 4].
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
    let settings = ConeSettings(params.stepper, params.step);
    let cones = DiffuseCones(FULL_RING, 0.0);
    let p_voxel = vec3f(cell) + 0.5;
    var arriving = vec3f(0.0);
    if (any(surface.normal != vec3f(0.0))) {
        arriving = gather_diffuse(p_voxel, surface.normal, cones, settings, params.start).rgb;
    } else {
        for (var axis = 0; axis < 3; axis++) {
            var normal = vec3f(0.0);
            normal[axis] = 1.0;
            arriving += (gather_diffuse(p_voxel, normal, cones, settings, params.start).rgb + gather_diffuse(p_voxel, -normal, cones, settings, params.start).rgb) / 6.0;
        }
    }
    var radiance = surface.albedo / PI * arriving;
    if (ADD_DIRECT) {
        radiance += direct[slot].rgb;
    }
    bounced[slot] = vec4f(radiance, 1.0);
}
