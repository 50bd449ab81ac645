// Runs an effect for every texel of its image.

import package::common::surface::{screen_pixel, surface_load};
import package::common::share::share_at;
import package::effect::{Params, effect};
import package::texel::{image, store_texel};

var<uniform> params: Params;

// Texels along each side of a tile that share out the directions; `interleave` then takes their mean.
override INTERLEAVE: u32 = 1;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    if (any(id.xy >= size)) {
        return;
    }
    var surface = surface_load(screen_pixel(id.xy, size));
    var value = vec4f(0.0);
    if (surface.hit) {
        surface.pixel = id.xy;
        surface.image_size = size;
        surface.layer = id.z;
        surface.share = share_at(id.xy, INTERLEAVE);
        value = effect(surface, params);
    }
    store_texel(id.xy, id.z, value);
}
