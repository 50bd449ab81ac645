// Ambient occlusion (RAU §6.3): 1 − (1/π) ∫ f(distance to what is hit) cosθ dω over the hemisphere, with
// f(t) = 1 / (1 + falloff·t) up to `distance` and 0 beyond (DVS §4.2). 1 is open, 0 is closed.

import package::common::basis::basis_around;
import package::common::diffuse_cones::{DIFFUSE_HALF_SINE, DiffuseCones, diffuse_direction, diffuse_weight};
import package::common::grid::grid;
import package::common::surface::Surface;
import package::common::trace::{Apex, reach_of};
import package::tracer::trace::trace_opacity;

struct Params {
    /// Where traces begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
    /// Farthest occluder, as a share of the grid's longest side.
    distance: f32,
    /// How fast occluders lose weight: per longest side of the grid.
    falloff: f32,
    /// Directions around the axis, [1, 8]; together they stand for the ring of five.
    ring: u32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let longest = f32(max(grid.size.x, max(grid.size.y, grid.size.z)));
    let apex = Apex(surface.position_voxel, surface.normal, params.start);
    let tangents = basis_around(surface.normal);
    let reach = reach_of(params.distance * longest);
    let cones = DiffuseCones(params.ring, surface.turn);
    var occlusion = 0.0;
    for (var i = 0u; i <= cones.ring; i++) {
        let direction = tangents * diffuse_direction(cones, i);
        let opacity = trace_opacity(apex, direction, DIFFUSE_HALF_SINE, reach, params.falloff / longest);
        occlusion += diffuse_weight(cones, i) * opacity;
    }
    return vec4f(vec3f(1.0 - occlusion), 1.0);
}
