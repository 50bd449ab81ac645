// SH mipmapping. `composited`: the parent shows to each side what its children do, the nearer over the farther. `linear`: the
// mean of the children's coefficients; `projected`: of what they send through the parent's faces; either as
// bright as the parent is opaque. Opacities composite as the six faces' do, so that a thin wall stays opaque.
// Level 1 makes coefficients of an isotropic level 0.

import package::common::volume::{block_texel, load_volume};
import package::encoding::{SignedVolumeTarget, encode_radiances};
import package::format::cell::{COVERAGE, Cell, CoverageTarget, HARMONICS, coverage_texel, encode_cell, load_cell, seen_from};
import package::format::options::{BASE, BASE_ISOTROPIC, MIP, MIP_COMPOSITED, MIP_PROJECTED};
import package::format::project::project_child;
import package::format::voxel::voxel_cell;

var base_source: texture_3d<f32>;
var harmonics_source: texture_3d<f32>;
var coverage_source: texture_3d<f32>;
var harmonics_target: SignedVolumeTarget;
var coverage_target: CoverageTarget;

fn over(near: vec4f, far: vec4f) -> vec4f {
    return near + (1.0 - near.a) * far;
}

// What a parent shows along each axis; the observer is on the side of children with a 1 in `near`. Child i lies
// at (i & 1, i >> 1 & 1, i >> 2).
fn composite(seen: array<mat3x4f, 8>, near: u32) -> mat3x4f {
    var s = seen;
    var sum = mat3x4f();
    for (var column = 0u; column < 4; column++) {
        let low = vec3u(column << 1, ((column & 2) << 1) | (column & 1), column);
        let first = low + near * vec3u(1, 2, 4);
        let last = low + (1 - near) * vec3u(1, 2, 4);
        sum += mat3x4f(
            over(s[first.x][0], s[last.x][0]),
            over(s[first.y][1], s[last.y][1]),
            over(s[first.z][2], s[last.z][2]),
        );
    }
    return sum * 0.25;
}

fn sides_opacity(c: Cell) -> f32 {
    return dot(c.positive + c.negative, vec3f(1.0));
}

fn voxel_mipmap(cell: vec3u, level: u32) {
    var positive: array<mat3x4f, 8>;
    var negative: array<mat3x4f, 8>;
    var sum = Cell();
    var weight = 0.0;
    for (var i = 0u; i < 8; i++) {
        let offset = vec3u(i & 1, (i >> 1) & 1, i >> 2);
        let place = cell * 2 + offset;
        var c: Cell;
        if (level == 1 && BASE == BASE_ISOTROPIC) {
            c = voxel_cell(place, load_volume(base_source, place));
        } else {
            c = load_cell(harmonics_source, coverage_source, place);
        }
        positive[i] = seen_from(c, vec3f(-1.0));
        negative[i] = seen_from(c, vec3f(1.0));
        if (MIP != MIP_COMPOSITED) {
            if (MIP == MIP_PROJECTED) {
                c = project_child(c, 1.0 - 2.0 * vec3f(offset));
            }
            sum.band0 += c.band0;
            sum.band1 += c.band1;
            weight += sides_opacity(c);
        }
    }
    var parent = encode_cell(composite(positive, 1), composite(negative, 0));
    if (MIP != MIP_COMPOSITED) {
        let scale = sides_opacity(parent) / max(weight, 1e-6);
        parent.band0 = sum.band0 * scale;
        parent.band1 = sum.band1 * scale;
    }
    let depth = textureDimensions(coverage_target).z / COVERAGE;
    for (var axis = 0u; axis < HARMONICS; axis++) {
        let texel = block_texel(cell, axis, HARMONICS, depth * HARMONICS);
        textureStore(harmonics_target, texel, encode_radiances(vec4f(parent.band1[axis], parent.band0[axis])));
    }
    textureStore(coverage_target, cell, coverage_texel(parent.positive));
    textureStore(coverage_target, block_texel(cell, 1, COVERAGE, depth * COVERAGE), coverage_texel(parent.negative));
}
