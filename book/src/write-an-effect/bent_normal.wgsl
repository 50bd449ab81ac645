// Bent normals: the mean direction from which a surface is open (Landis, "Production-Ready Global Illumination",
// SIGGRAPH 2002); alpha is how open it is, [0, 1].

import package::common::basis::basis_around;
import package::common::cone::{ConeSettings, cone_trace};
import package::common::diffuse_cones::{DiffuseCones, FULL_RING, diffuse_cone, diffuse_direction, diffuse_weight};
import package::common::grid::grid;
import package::common::surface::Surface;

struct Params {
    /// 1: tangent spheres; 2: the 60° doubling cone.
    stepper: u32,
    /// Step over cell size, of the tangent spheres, (0, 1].
    step: f32,
    /// Farthest occluder, as a share of the grid's longest side, (0, 2].
    distance: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let longest = f32(max(grid.size.x, max(grid.size.y, grid.size.z)));
    let tangents = basis_around(surface.normal);
    var open = vec4f(0.0);
    let cones = DiffuseCones(FULL_RING, 0.0);
    for (var i = 0u; i <= cones.ring; i++) {
        let cone = diffuse_cone(surface.position_voxel, tangents, cones, i, 1.0, params.distance * longest);
        let value = cone_trace(cone, ConeSettings(params.stepper, params.step), 0.0);
        let weight = diffuse_weight(cones, i) * (1.0 - value.a);
        open += weight * vec4f(tangents * diffuse_direction(cones, i), 1.0);
    }
    let size = length(open.xyz);
    // Where nothing is open there is no such direction: the normal stays.
    let bent = select(surface.normal, open.xyz / max(size, 1e-6), size > 1e-3);
    return vec4f(bent, open.a);
}
