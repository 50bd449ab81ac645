// Diffuse interreflection (RAU §6.4): irradiance that the lit scene and the sky send to the surface,
// W·m⁻², gathered over the hemisphere. Alpha is the mean opacity met.

import package::common::diffuse_cones::{DiffuseCones, gather_diffuse};
import package::common::surface::Surface;
import package::common::trace::Apex;

struct Params {
    /// Where traces begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
    /// Directions around the axis, [1, 8]; together they stand for the ring of five.
    ring: u32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let apex = Apex(surface.position_voxel, surface.normal, params.start);
    return gather_diffuse(apex, DiffuseCones(params.ring, surface.turn));
}
