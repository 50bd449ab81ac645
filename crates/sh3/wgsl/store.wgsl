// Level 0 is isotropic; coefficients begin at level 1.

import package::encoding::{VolumeTarget, encode_texel};

var base_level0: VolumeTarget;

fn voxel_store(cell: vec3u, radiance: vec3f, normal: vec3f, opacity: f32) {
    textureStore(base_level0, cell, encode_texel(vec4f(radiance * opacity, opacity)));
}
