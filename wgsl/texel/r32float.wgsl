// Texels of an image that a shader writes. One float: the first number of a value.

var image: texture_storage_2d_array<r32float, write>;

fn store_texel(texel: vec2u, layer: u32, value: vec4f) {
    textureStore(image, texel, layer, value);
}
