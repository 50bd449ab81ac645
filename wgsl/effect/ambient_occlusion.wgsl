// Ambient occlusion (RAU §6.3): 1 − (1/π) ∫ f(distance to what is hit) cosθ dω over the hemisphere, with
// f(t) = 1 / (1 + falloff·t) up to `distance` and 0 beyond (DVS §4.2). 1 is open, 0 is closed.

import package::common::basis::basis_around;
import package::common::cone::{ConeSettings, cone_opacity};
import package::common::diffuse_cones::{DiffuseCones, diffuse_cone, diffuse_weight};
import package::common::grid::grid;
import package::common::surface::Surface;

struct Params {
    /// 1: tangent spheres; 2: the 60° doubling cone.
    stepper: u32,
    /// Step over cell size, of the tangent spheres, (0, 1].
    step: f32,
    /// Where cones begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
    /// Farthest occluder, as a share of the grid's longest side.
    distance: f32,
    /// How fast occluders lose weight: per longest side of the grid.
    falloff: f32,
    /// Cones around the axis, [1, 8]; together they stand for the ring of five.
    ring: u32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let longest = f32(max(grid.size.x, max(grid.size.y, grid.size.z)));
    let tangents = basis_around(surface.normal);
    var occlusion = 0.0;
    let cones = DiffuseCones(params.ring, surface.turn);
    for (var i = 0u; i <= cones.ring; i++) {
        let cone = diffuse_cone(surface.position_voxel, tangents, cones, i, params.start, params.distance * longest);
        let opacity = cone_opacity(cone, ConeSettings(params.stepper, params.step), params.falloff / longest);
        occlusion += diffuse_weight(cones, i) * opacity;
    }
    return vec4f(vec3f(1.0 - occlusion), 1.0);
}
