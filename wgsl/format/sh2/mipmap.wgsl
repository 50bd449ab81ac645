// SH mipmapping. `linear`: the mean of the children's coefficients, exact for both bands; `projected`: the mean of what they
// send through the parent's faces; either as bright as the parent is opaque. Opacities composite as the six faces' do, so
// that a thin wall stays opaque. Level 1 makes coefficients of an isotropic level 0.

import package::common::coverage::composite_coverage;
import package::common::volume::{block_texel, load_volume};
import package::encoding::{SignedVolumeTarget, encode_radiances};
import package::format::cell::{COVERAGE, Cell, CoverageTarget, HARMONICS, coverage_texel, load_cell, sides_opacity};
import package::format::options::{BASE, BASE_ISOTROPIC, MIP, MIP_PROJECTED};
import package::format::project::project_child;
import package::format::voxel::voxel_cell;

var base_source: texture_3d<f32>;
var harmonics_source: texture_3d<f32>;
var coverage_source: texture_3d<f32>;
var harmonics_target: SignedVolumeTarget;
var coverage_target: CoverageTarget;

fn voxel_mipmap(cell: vec3u, level: u32) {
    var positive: array<vec3f, 8>;
    var negative: array<vec3f, 8>;
    var parent = Cell();
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
        positive[i] = c.positive;
        negative[i] = c.negative;
        weight += sides_opacity(c);
        if (MIP == MIP_PROJECTED) {
            c = project_child(c, 1.0 - 2.0 * vec3f(offset));
        }
        parent.band0 += c.band0;
        parent.band1 += c.band1;
    }
    parent.positive = composite_coverage(positive);
    parent.negative = composite_coverage(negative);
    let scale = sides_opacity(parent) / max(weight, 1e-6);
    let depth = textureDimensions(coverage_target).z / COVERAGE;
    for (var axis = 0u; axis < HARMONICS; axis++) {
        let texel = block_texel(cell, axis, HARMONICS, depth * HARMONICS);
        textureStore(harmonics_target, texel, encode_radiances(scale * vec4f(parent.band1[axis], parent.band0[axis])));
    }
    textureStore(coverage_target, cell, coverage_texel(parent.positive));
    textureStore(coverage_target, block_texel(cell, 1, COVERAGE, depth * COVERAGE), coverage_texel(parent.negative));
}
