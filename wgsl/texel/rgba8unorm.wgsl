// Texels of an image that a shader writes. Four shares of 1, 8 bits each.

var image: texture_storage_2d_array<rgba8unorm, write>;

fn store_texel(texel: vec2u, layer: u32, value: vec4f) {
    textureStore(image, texel, layer, value);
}
