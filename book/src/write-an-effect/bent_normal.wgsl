// Bent normals: the mean direction from which a surface is open (Landis, "Production-Ready Global Illumination",
// SIGGRAPH 2002); alpha is how open it is, [0, 1].

import package::common::basis::basis_around;
import package::common::diffuse_cones::{DIFFUSE_HALF_SINE, DiffuseCones, FULL_RING, diffuse_direction, diffuse_weight};
import package::common::grid::longest_side;
import package::common::surface::{Surface, surface_apex};
import package::common::trace::{cone_lobe, reach_of};
import package::tracer::trace::trace_opacity;

struct Params {
    /// Farthest occluder, as a share of the grid's longest side, (0, 2].
    distance: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let apex = surface_apex(surface);
    let reach = reach_of(params.distance * longest_side());
    let tangents = basis_around(surface.normal);
    var open = vec4f(0.0);
    let cones = DiffuseCones(FULL_RING, 0.0);
    for (var i = 0u; i <= cones.ring; i++) {
        let direction = tangents * diffuse_direction(cones, i);
        let opacity = trace_opacity(apex, cone_lobe(direction, DIFFUSE_HALF_SINE), reach, 0.0);
        open += diffuse_weight(cones, i) * (1.0 - opacity) * vec4f(direction, 1.0);
    }
    let size = length(open.xyz);
    // Where nothing is open there is no such direction: the normal stays.
    let bent = select(surface.normal, open.xyz / max(size, 1e-6), size > 1e-3);
    return vec4f(bent, open.a);
}
