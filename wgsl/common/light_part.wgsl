// A part of a light as seen from a point.

import package::common::basis::basis_around;
import package::common::constants::GOLDEN_ANGLE;
import package::common::light::{Incidence, Light, area_corners, area_part, HAS_AREA, LIGHT_AREA};

// Point (u, v) of a quad, both in [0, 1].
fn quad_point(c: array<vec3f, 4>, u: f32, v: f32) -> vec3f {
    return mix(mix(c[0], c[1], u), mix(c[3], c[2], u), v);
}

// Direction number `index` of as many, spread by a spiral evenly over the solid angle of a disc.
fn disc_direction(whole: Incidence, index: u32, count: u32) -> vec3f {
    // 1 less the cosine, so that a narrow disc keeps its digits.
    let span = whole.sine * whole.sine / (1.0 + sqrt(max(1.0 - whole.sine * whole.sine, 0.0)));
    let below = (f32(index) + 0.5) / f32(count) * span;
    let radius = sqrt(below * (2.0 - below));
    let angle = f32(index) * GOLDEN_ANGLE;
    return basis_around(whole.direction) * vec3f(radius * cos(angle), radius * sin(angle), 1.0 - below);
}

// The corners of one of an area light's `sides` × `sides` pieces.
fn light_piece(light: Light, index: u32, sides: u32) -> array<vec3f, 4> {
    let corners = area_corners(light);
    let low = vec2f(vec2u(index % sides, index / sides)) / f32(sides);
    let high = low + 1.0 / f32(sides);
    return array(
        quad_point(corners, low.x, low.y),
        quad_point(corners, high.x, low.y),
        quad_point(corners, high.x, high.y),
        quad_point(corners, low.x, high.y),
    );
}

// What a part gives a surface, up to a factor that all parts share: of a piece its form factor, as if it were small.
fn part_weight(light: Light, whole: Incidence, index: u32, sides: u32, position: vec3f, normal: vec3f) -> f32 {
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        let c = area_corners(light);
        let at = (vec2f(vec2u(index % sides, index / sides)) + 0.5) / f32(sides);
        let offset = quad_point(c, at.x, at.y) - position;
        let distance2 = max(dot(offset, offset), 1e-30);
        // Of a flat quad the area changes evenly along both sides: that of a piece is as in its middle.
        let area = length(cross(mix(c[1] - c[0], c[2] - c[3], at.y), mix(c[3] - c[0], c[2] - c[1], at.x)));
        return max(dot(offset, normal), 0.0) * abs(dot(offset, light.direction)) * area / (distance2 * distance2);
    }
    return max(dot(disc_direction(whole, index, sides * sides), normal), 0.0);
}

// With at most 4 along each side.
const MOST_PARTS = 16u;

// Which of `sides` × `sides` parts of a light a turn in [0, 1) falls to, each as often as it gives a share of the irradiance; as many
// as there are where no part's middle is above the horizon.
fn part_at(light: Light, whole: Incidence, sides: u32, turn: f32, position: vec3f, normal: vec3f) -> u32 {
    let count = sides * sides;
    var weights: array<f32, MOST_PARTS>;
    var sum = 0.0;
    for (var i = 0u; i < count; i++) {
        weights[i] = part_weight(light, whole, i, sides, position, normal);
        sum += weights[i];
    }
    var left = turn * sum;
    var index = count;
    for (var i = 0u; i < count; i++) {
        if (weights[i] > 0.0 && left >= 0.0) {
            index = i;
        }
        left -= weights[i];
    }
    return index;
}

// A part of a light, a piece of its polygon or a smaller disc of its disc. Parts are met as often as they give a share of the
// irradiance, so that what is seen of the parts is what arrives of the irradiance.
fn light_part(light: Light, whole: Incidence, sides: u32, turn: f32, position: vec3f, normal: vec3f) -> Incidence {
    var part = whole;
    let is_area = HAS_AREA && light.kind == LIGHT_AREA;
    if (is_area || whole.sine > 0.0) {
        let index = part_at(light, whole, sides, turn, position, normal);
        if (index < sides * sides) {
            if (is_area) {
                part = area_part(light_piece(light, index, sides), light, position, whole.irradiance);
            } else {
                let direction = disc_direction(whole, index, sides * sides);
                part = Incidence(direction, whole.distance, whole.sine / f32(sides), whole.irradiance);
            }
        }
    }
    return part;
}
