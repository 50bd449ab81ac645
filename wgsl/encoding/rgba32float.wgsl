// Four floats a texel, on devices that filter them.

import package::common::volume_sampler::volume_sampler;

alias VolumeTarget = texture_storage_3d<rgba32float, write>;
alias SignedVolumeTarget = texture_storage_3d<rgba32float, write>;

fn encode_texel(value: vec4f) -> vec4f {
    return value;
}

fn decode_texel(texel: vec4f) -> vec4f {
    return texel;
}

fn filter_volume(volume: texture_3d<f32>, uvw: vec3f, level: f32) -> vec4f {
    return textureSampleLevel(volume, volume_sampler, uvw, level);
}
