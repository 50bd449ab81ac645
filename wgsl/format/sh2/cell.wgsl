// A cell as two bands of spherical harmonics. Its surfaces stand as facets that look along the axes, each a one-sided
// Lambertian emitter as bright as what an observer on that side sees. A facet of premultiplied radiance R and normal n has the
// coefficients √π·R and √(3π)/2·R·n (RAU eq. 5.1 with the constant of its figure B.3). Kept are those of all six over 2√π and
// √(3π)/2: half the sum of what the sides show, and along each axis by how much the positive side shows more.
//
// Three texels hold what the sides show more along x, y and z, their alphas the half sum. Two more, of bytes, hold
// the opacities seen from +x, +y, +z and from −x, −y, −z.

import package::common::volume::block_texel;
import package::encoding::decode_radiances;

const HARMONICS = 3u;
const COVERAGE = 2u;

alias CoverageTarget = texture_storage_3d<rgba8unorm, write>;

struct Cell {
    band0: vec3f,
    // Of x, y and z.
    band1: mat3x3f,
    // Opacities, [0, 1].
    positive: vec3f,
    negative: vec3f,
}

// Of what is seen from +x, +y, +z and from −x, −y, −z: premultiplied radiance and opacity.
fn encode_cell(positive: mat3x4f, negative: mat3x4f) -> Cell {
    let sum = positive + negative;
    let more = positive - negative;
    return Cell(
        0.5 * (sum[0].rgb + sum[1].rgb + sum[2].rgb),
        mat3x3f(more[0].rgb, more[1].rgb, more[2].rgb),
        vec3f(positive[0].a, positive[1].a, positive[2].a),
        vec3f(negative[0].a, negative[1].a, negative[2].a),
    );
}

// What both sides of the axes show in all, which two bands don't tell apart.
fn shared_in_all(cell: Cell) -> vec3f {
    let more = abs(cell.band1[0]) + abs(cell.band1[1]) + abs(cell.band1[2]);
    return max(cell.band0 - 0.5 * more, vec3f(0.0));
}

// The share of it that each axis is taken to have: that which it has of what is opaque from both sides.
fn share_of_axes(cell: Cell) -> vec3f {
    let both = min(cell.positive, cell.negative);
    return both / max(both.x + both.y + both.z, 1e-6);
}

// What an observer sees along one axis who looks along the axes in these directions, 1 or −1: what both sides show, and what this one has more.
fn seen_along(cell: Cell, axis: u32, ahead: vec3f, of_both: vec3f) -> vec4f {
    let opacity = select(cell.positive, cell.negative, ahead > vec3f(0.0))[axis];
    return vec4f(of_both + max(-ahead[axis] * cell.band1[axis], vec3f(0.0)), opacity);
}

// Along all of them.
fn seen_from(cell: Cell, ahead: vec3f) -> mat3x4f {
    let all = shared_in_all(cell);
    let share = share_of_axes(cell);
    return mat3x4f(
        seen_along(cell, 0, ahead, all * share.x),
        seen_along(cell, 1, ahead, all * share.y),
        seen_along(cell, 2, ahead, all * share.z),
    );
}

// Opacities as bytes. What is there at all keeps the least, since light is seen by its opacity.
fn coverage_texel(opacity: vec3f) -> vec4f {
    return vec4f(select(vec3f(0.0), max(opacity, vec3f(1.0 / 255.0)), opacity > vec3f(0.0)), 0.0);
}

fn load_cell(harmonics: texture_3d<f32>, coverage: texture_3d<f32>, place: vec3u) -> Cell {
    let depth = textureDimensions(coverage).z / COVERAGE;
    var more: array<vec4f, 3>;
    for (var axis = 0u; axis < HARMONICS; axis++) {
        let texel = block_texel(place, axis, HARMONICS, depth * HARMONICS);
        more[axis] = decode_radiances(textureLoad(harmonics, texel, 0));
    }
    return Cell(
        vec3f(more[0].a, more[1].a, more[2].a),
        mat3x3f(more[0].rgb, more[1].rgb, more[2].rgb),
        textureLoad(coverage, block_texel(place, 0, COVERAGE, depth * COVERAGE), 0).xyz,
        textureLoad(coverage, block_texel(place, 1, COVERAGE, depth * COVERAGE), 0).xyz,
    );
}
