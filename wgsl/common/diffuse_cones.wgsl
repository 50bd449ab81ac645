// The hemisphere as cones of 60°, one about the axis and a ring of five around it (RAU eq. 6.8), weighted by their
// share of the cosine lobe (RAU eq. 6.9 over π): 1/4 for the axis, 3/4 for the ring. A ring of fewer cones stands
// for the same band; where neighbouring pixels turn it differently, they fill it together.

import package::common::constants::TAU;

const DIFFUSE_HALF_SINE = 0.5;
const FULL_RING = 5u;

// How the hemisphere is covered: the ring's cones, and how far it is turned, [0, 1) of the angle between two of them.
struct DiffuseCones {
    ring: u32,
    turn: f32,
}

// About +z. Cone 0 is the axis.
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
