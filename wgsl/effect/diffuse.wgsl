// Diffuse interreflection (RAU §6.4): irradiance that the lit scene and the sky send to the surface,
// W·m⁻², gathered over the hemisphere. Alpha is the mean opacity met.

import package::common::constants::PI;
import package::common::surface::{Surface, surface_apex};
import package::common::trace::{hemisphere_lobe, reach_of};
import package::tracer::trace::trace_gather;

struct Params {
    /// Where traces begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let found = trace_gather(surface_apex(surface, params.start), hemisphere_lobe(surface.normal), reach_of(1e30));
    return vec4f(PI * found.radiance, found.opacity);
}
