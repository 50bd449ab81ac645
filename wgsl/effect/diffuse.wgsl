// Diffuse interreflection (RAU §6.4): irradiance that the lit scene and the sky send to the surface,
// W·m⁻², gathered over the hemisphere. Alpha is the mean opacity met.

import package::common::constants::PI;
import package::common::grid::longest_side;
import package::common::leaning::leaning;
import package::common::surface::{Surface, surface_apex};
import package::common::trace::{hemisphere_lobe, reach_of};
import package::emitters::emitters_irradiance;
import package::tracer::trace::trace_gather;

struct Params {
    /// Farthest surface that sends light, as a share of the grid's longest side; beyond it is the sky; 1000 unless given.
    distance: f32,
    /// Rays to emissive polygons, where there are many, [1, 64]; 2 unless given.
    lamps: u32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let found = trace_gather(surface_apex(surface), hemisphere_lobe(surface.normal), reach_of(params.distance * longest_side()));
    let lamps = emitters_irradiance(surface_apex(surface), surface.normal, params.lamps);
    // Light as wide as the hemisphere falls with half of a normal's turn, as (1 + cos)/2, since none of it counts from below.
    leaning = PI * vec4f(found.vector, length(found.vector)) + vec4f(lamps.vector, 0.0);
    return vec4f(PI * found.radiance + lamps.irradiance, found.opacity);
}
