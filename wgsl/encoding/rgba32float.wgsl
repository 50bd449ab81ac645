// Four floats a texel.

import package::common::out_of_range::clamp_to_range;

alias VolumeTarget = texture_storage_3d<rgba32float, write>;
alias SignedVolumeTarget = texture_storage_3d<rgba32float, write>;

// Less than they hold, so that sums of texels stay finite.
fn encode_texel(value: vec4f) -> vec4f {
    return clamp_to_range(value, vec4f(1e30));
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
