// A part of a light as seen from a point.

import package::common::basis::basis_around;
import package::common::light::{Incidence, Light, area_corners, area_part, HAS_AREA, LIGHT_AREA};

const GOLDEN_ANGLE = 2.39996323;

// Point (u, v) of a quad, both in [0, 1].
fn quad_point(c: array<vec3f, 4>, u: f32, v: f32) -> vec3f {
    return mix(mix(c[0], c[1], u), mix(c[3], c[2], u), v);
}

// Of an area light one of `sides` × `sides` parts; of a disc one of as many smaller discs that a spiral spreads evenly
// over it. `turn` in [0, 1) says which. Where the part's middle is below the horizon it is the whole: what of the light
// is above stands for the rest.
fn light_part(light: Light, whole: Incidence, sides: u32, turn: f32, position: vec3f, normal: vec3f) -> Incidence {
    let count = sides * sides;
    let index = min(u32(turn * f32(count)), count - 1);
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        let corners = area_corners(light);
        let low = vec2f(vec2u(index % sides, index / sides)) / f32(sides);
        let high = low + 1.0 / f32(sides);
        let part = array(
            quad_point(corners, low.x, low.y),
            quad_point(corners, high.x, low.y),
            quad_point(corners, high.x, high.y),
            quad_point(corners, low.x, high.y),
        );
        let incidence = area_part(part, light, position, whole.irradiance);
        if (dot(incidence.direction, normal) > 0.0) {
            return incidence;
        }
        return whole;
    }
    let radius = whole.tangent * sqrt((f32(index) + 0.5) / f32(count));
    let angle = f32(index) * GOLDEN_ANGLE;
    let direction = normalize(basis_around(whole.direction) * vec3f(radius * cos(angle), radius * sin(angle), 1.0));
    if (dot(direction, normal) <= 0.0) {
        return whole;
    }
    var part = whole;
    part.direction = direction;
    part.tangent = whole.tangent / f32(sides);
    return part;
}
