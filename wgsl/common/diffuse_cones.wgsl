// The hemisphere as cones of 60°, one about the axis and a ring of five around it (RAU eq. 6.8), weighted by their
// share of the cosine lobe (RAU eq. 6.9 over π): 1/4 for the axis, 3/4 for the ring. A ring of fewer cones stands
// for the same band; where neighbouring pixels turn it differently, they fill it together.

import package::common::basis::basis_around;
import package::common::cone::{Cone, ConeSettings, cone_trace, surface_cone};
import package::common::constants::{PI, TAU};
import package::common::environment::environment;

const DIFFUSE_SINE = 0.5;
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

// Cone `index` of a surface point.
fn diffuse_cone(p_voxel: vec3f, tangents: mat3x3f, cones: DiffuseCones, index: u32, start: f32, reach: f32) -> Cone {
    return surface_cone(p_voxel, tangents[2], tangents * diffuse_direction(cones, index), DIFFUSE_SINE, reach, start);
}

// Irradiance from the volume and the sky, W·m⁻², and the mean opacity.
fn gather_diffuse(p_voxel: vec3f, normal: vec3f, cones: DiffuseCones, settings: ConeSettings, start: f32) -> vec4f {
    let tangents = basis_around(normal);
    var sum = vec4f(0.0);
    for (var i = 0u; i <= cones.ring; i++) {
        let value = cone_trace(diffuse_cone(p_voxel, tangents, cones, i, start, 1e30), settings, 0.0);
        sum += diffuse_weight(cones, i) * vec4f(value.rgb + (1.0 - value.a) * environment.sky, value.a);
    }
    return vec4f(PI * sum.rgb, sum.a);
}
