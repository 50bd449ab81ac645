// Ambient occlusion (RAU §6.3): 1 − (1/π) ∫ f(distance to what is hit) cosθ dω over the hemisphere, with
// f(t) = 1 / (1 + falloff·t) up to `distance` and 0 beyond (DVS §4.2). 1 is open, 0 is closed.

import package::common::grid::longest_side;
import package::common::surface::{Surface, surface_apex};
import package::common::trace::{hemisphere_lobe, reach_of};
import package::tracer::trace::trace_opacity;

struct Params {
    /// Farthest occluder, as a share of the grid's longest side.
    distance: f32,
    /// How fast occluders lose weight: per longest side of the grid.
    falloff: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let longest = longest_side();
    let hemisphere = hemisphere_lobe(surface.normal);
    let reach = reach_of(params.distance * longest);
    let occlusion = trace_opacity(surface_apex(surface), hemisphere, reach, params.falloff / longest);
    return vec4f(vec3f(1.0 - occlusion), 1.0);
}
