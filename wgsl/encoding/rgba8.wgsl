// Four bytes a texel: RGB is a share of a declared range (RAU §5.1.3), alpha one of 1, or of four radiances one of the range too. Signed numbers have 127
// steps to either side, so that zero, which is what an untouched texel holds, is exact.

import package::common::out_of_range::clamp_to_range;

alias VolumeTarget = texture_storage_3d<rgba8unorm, write>;
alias SignedVolumeTarget = texture_storage_3d<rgba8snorm, write>;

override ENCODING_RANGE: f32 = 4.0;

fn encode_texel(value: vec4f) -> vec4f {
    let range = vec4f(vec3f(ENCODING_RANGE), 1.0);
    return clamp_to_range(value, range) / range;
}

fn decode_texel(texel: vec4f) -> vec4f {
    return texel * vec4f(vec3f(ENCODING_RANGE), 1.0);
}

fn encode_radiances(values: vec4f) -> vec4f {
    return clamp_to_range(values, vec4f(ENCODING_RANGE)) / ENCODING_RANGE;
}

fn decode_radiances(texel: vec4f) -> vec4f {
    return texel * ENCODING_RANGE;
}
