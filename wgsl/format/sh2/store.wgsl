// Two bands of spherical harmonics: level 0 is isotropic and coefficients begin at level 1, or at level 0.

import package::common::volume::block_texel;
import package::encoding::{SignedVolumeTarget, VolumeTarget, encode_radiances, encode_texel};
import package::format::cell::{COVERAGE, CoverageTarget, HARMONICS, coverage_texel};
import package::format::options::{BASE, BASE_ISOTROPIC};
import package::format::voxel::voxel_cell;

var base_level0: VolumeTarget;
var harmonics_level0: SignedVolumeTarget;
var coverage_level0: CoverageTarget;

fn voxel_store(cell: vec3u, radiance: vec3f, normal: vec3f, opacity: f32) {
    let value = vec4f(radiance * opacity, opacity);
    if (BASE == BASE_ISOTROPIC) {
        textureStore(base_level0, cell, encode_texel(value));
        return;
    }
    let c = voxel_cell(cell, value);
    let depth = textureDimensions(coverage_level0).z / COVERAGE;
    for (var axis = 0u; axis < HARMONICS; axis++) {
        let texel = block_texel(cell, axis, HARMONICS, depth * HARMONICS);
        textureStore(harmonics_level0, texel, encode_radiances(vec4f(c.band1[axis], c.band0[axis])));
    }
    textureStore(coverage_level0, cell, coverage_texel(c.positive));
    textureStore(coverage_level0, block_texel(cell, 1, COVERAGE, depth * COVERAGE), coverage_texel(c.negative));
}
