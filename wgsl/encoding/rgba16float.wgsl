// Four half floats a texel. What is larger than they hold becomes the largest, never infinity.

import package::common::out_of_range::clamp_to_range;

alias VolumeTarget = texture_storage_3d<rgba16float, write>;
alias SignedVolumeTarget = texture_storage_3d<rgba16float, write>;

fn encode_texel(value: vec4f) -> vec4f {
    return clamp_to_range(value, vec4f(65504.0));
}

fn decode_texel(texel: vec4f) -> vec4f {
    return texel;
}

fn encode_radiances(values: vec4f) -> vec4f {
    return encode_texel(values);
}

fn decode_radiances(texel: vec4f) -> vec4f {
    return texel;
}
