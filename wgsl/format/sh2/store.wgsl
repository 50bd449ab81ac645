// 2-band spherical harmonics: level 0 is isotropic and coefficients begin at level 1, or at level 0.

import package::common::volume::block_texel;
import package::encoding::{SignedVolumeTarget, VolumeTarget, encode_texel};
import package::format::basis::COEFFICIENTS;
import package::format::lobe::voxel_lobe;
import package::format::options::{BASE, BASE_ISOTROPIC};

@group(2) @binding(8) var base_level0: VolumeTarget;
@group(2) @binding(9) var harmonics_level0: SignedVolumeTarget;

fn voxel_store(cell: vec3u, radiance: vec3f, normal: vec3f, opacity: f32) {
    let value = vec4f(radiance * opacity, opacity);
    if (BASE == BASE_ISOTROPIC) {
        textureStore(base_level0, cell, encode_texel(value));
        return;
    }
    let depth = textureDimensions(harmonics_level0).z;
    var c = voxel_lobe(cell, value);
    for (var k = 0u; k < COEFFICIENTS; k++) {
        textureStore(harmonics_level0, block_texel(cell, k, COEFFICIENTS, depth), encode_texel(c[k]));
    }
}
