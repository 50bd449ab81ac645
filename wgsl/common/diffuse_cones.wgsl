// The hemisphere as cones of 60°, one about the axis and a ring of five around it (RAU eq. 6.8), weighted by their
// share of the cosine lobe (RAU eq. 6.9 over π): 1/4 for the axis, 3/4 for the ring. A ring of fewer cones stands
// for the same band; where neighbouring pixels turn it differently, they fill it together.

import package::common::basis::basis_around;
import package::common::constants::{PI, TAU};
import package::common::environment::environment;
import package::common::trace::{Apex, reach_of};
import package::tracer::trace::trace_gather;

const DIFFUSE_HALF_SINE = 0.5;
const FULL_RING = 5u;

// How the hemisphere is covered: the ring's cones, and how far it is turned, [0, 1) of the angle between two of them.
struct DiffuseCones {
    ring: u32,
    turn: f32,
}

// Cone 0 is the axis.
fn diffuse_direction(cones: DiffuseCones, index: u32) -> vec3f {
    if (index == 0) {
        return vec3f(0.0, 0.0, 1.0);
    }
    let azimuth = TAU * (f32(index) + cones.turn) / f32(cones.ring);
    return vec3f(0.8660254 * sin(azimuth), 0.8660254 * cos(azimuth), 0.5);
}

fn diffuse_weight(cones: DiffuseCones, index: u32) -> f32 {
    return select(0.75 / f32(cones.ring), 0.25, index == 0);
}

// Irradiance from the scene and the sky, W·m⁻², and the mean opacity.
fn gather_diffuse(apex: Apex, cones: DiffuseCones) -> vec4f {
    let tangents = basis_around(apex.normal);
    var sum = vec4f(0.0);
    for (var i = 0u; i <= cones.ring; i++) {
        let found = trace_gather(apex, tangents * diffuse_direction(cones, i), DIFFUSE_HALF_SINE, reach_of(1e30));
        let arriving = found.radiance + (1.0 - found.opacity) * environment.sky;
        sum += diffuse_weight(cones, i) * vec4f(arriving, found.opacity);
    }
    return vec4f(PI * sum.rgb, sum.a);
}
