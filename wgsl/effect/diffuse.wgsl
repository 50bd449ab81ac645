// Diffuse interreflection (RAU §6.4): irradiance that the lit scene and the sky send to the surface,
// W·m⁻², gathered by cones of 60°. Alpha is the mean opacity met.

import package::common::cone::ConeSettings;
import package::common::diffuse_cones::{DiffuseCones, gather_diffuse};
import package::common::surface::Surface;

struct Params {
    /// 1: tangent spheres; 2: the 60° doubling cone.
    stepper: u32,
    /// Step over cell size, of the tangent spheres, (0, 1].
    step: f32,
    /// Where cones begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
    /// Cones around the axis, [1, 8]; together they stand for the ring of five.
    ring: u32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let cones = DiffuseCones(params.ring, surface.turn);
    return gather_diffuse(surface.position_voxel, surface.normal, cones, ConeSettings(params.stepper, params.step), params.start);
}
