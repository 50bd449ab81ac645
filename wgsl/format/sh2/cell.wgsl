// A cell as two bands of spherical harmonics. A one-sided Lambertian emitter of premultiplied radiance R and normal n has the
// coefficients √π·R and √(3π)/2·R·n (RAU eq. 5.1 with the constant of its figure B.3). Kept are those over 2√π and √(3π)/2.
//
// Three texels hold band 1 along x, y and z, their alphas the three colours of band 0. Two more, of bytes, hold
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

// Surfaces of one radiance, as opaque as this from the two sides of each axis. They emit along the normal that this tells; what is
// as opaque from behind as from ahead sends as much to either side.
fn emitter(radiance: vec3f, positive: vec3f, negative: vec3f) -> Cell {
    let sum = dot(positive + negative, vec3f(1.0));
    let more = positive - negative;
    let facing = more * (dot(abs(more), vec3f(1.0)) / max(length(more), 1e-6));
    return Cell(radiance * (0.5 * sum), mat3x3f(radiance * facing.x, radiance * facing.y, radiance * facing.z), positive, negative);
}

fn sides_opacity(c: Cell) -> f32 {
    return dot(c.positive + c.negative, vec3f(1.0));
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
