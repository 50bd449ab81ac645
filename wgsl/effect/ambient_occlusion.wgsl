// Ambient occlusion (RAU §6.3): 1 − (1/π) ∫ f(distance to what is hit) cosθ dω over the hemisphere, with
// f(t) = 1 / (1 + falloff·t) up to `distance` and 0 beyond (DVS §4.2). 1 is open, 0 is closed.

import package::common::grid::grid;
import package::common::surface::{Surface, surface_apex};
import package::common::trace::{hemisphere_lobe, reach_of};
import package::tracer::trace::trace_opacity;

struct Params {
    /// Where traces begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
    /// Farthest occluder, as a share of the grid's longest side.
    distance: f32,
    /// How fast occluders lose weight: per longest side of the grid.
    falloff: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let longest = f32(max(grid.size.x, max(grid.size.y, grid.size.z)));
    let hemisphere = hemisphere_lobe(surface.normal);
    let reach = reach_of(params.distance * longest);
    let occlusion = trace_opacity(surface_apex(surface, params.start), hemisphere, reach, params.falloff / longest);
    return vec4f(vec3f(1.0 - occlusion), 1.0);
}
