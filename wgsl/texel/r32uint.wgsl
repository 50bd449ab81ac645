// Texels of an image that a shader writes. A whole number: the first number of a value, rounded down.

var image: texture_storage_2d_array<r32uint, write>;

fn store_texel(texel: vec2u, layer: u32, value: vec4f) {
    textureStore(image, texel, layer, vec4u(u32(max(value.r, 0.0))));
}
