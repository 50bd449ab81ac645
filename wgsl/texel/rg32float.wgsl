// Texels of an image that a shader writes. Two floats: the first two numbers of a value.

var image: texture_storage_2d_array<rg32float, write>;

fn store_texel(texel: vec2u, layer: u32, value: vec4f) {
    textureStore(image, texel, layer, value);
}
