// Texels of an image that a shader writes. Four half floats. What is larger than they hold becomes the largest, never infinity.

import package::common::range::in_half_range;

var image: texture_storage_2d_array<rgba16float, write>;

fn store_texel(texel: vec2u, layer: u32, value: vec4f) {
    textureStore(image, texel, layer, vec4f(in_half_range(value.rgb), value.a));
}
