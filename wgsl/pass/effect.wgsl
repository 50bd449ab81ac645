// Runs an effect over the screen.

import package::common::surface::surface_load;
import package::effect::{Params, effect};

@group(3) @binding(0) var<uniform> params: Params;
@group(3) @binding(1) var image: texture_storage_2d_array<rgba16float, write>;

// Whether the pixels of a tile of 4 × 4 share out the directions; `interleave` then takes their mean.
override INTERLEAVE: bool = false;

// A tile's pixels in the order of Bayer's matrix: next neighbours are turned the most differently.
fn turn(pixel: vec2u) -> f32 {
    let x = pixel.x ^ pixel.y;
    let order = ((x & 1) << 3) | ((pixel.y & 1) << 2) | (x & 2) | ((pixel.y & 2) >> 1);
    return f32(order) / 16.0;
}

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (any(id.xy >= textureDimensions(image))) {
        return;
    }
    var surface = surface_load(id.xy);
    var value = vec4f(0.0);
    if (surface.hit) {
        surface.layer = id.z;
        surface.turn = select(0.0, turn(id.xy), INTERLEAVE);
        value = effect(surface, params);
    }
    textureStore(image, id.xy, id.z, value);
}
