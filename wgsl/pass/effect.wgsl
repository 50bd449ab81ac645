// Runs an effect for every texel of its image.

import package::common::surface::{screen_pixel, surface_load};
import package::common::turn::turn_at;
import package::effect::{Params, effect};
import package::texel::{image, store_texel};

var<uniform> params: Params;

// Whether the texels of a tile of 8 × 8 share out the directions; `interleave` then takes their mean.
override INTERLEAVE: bool = false;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    // A workgroup's threads trace the same set: their rays keep together.
    let tiles = (size + 7) / 8;
    let at = select(id.xy, (id.xy % tiles) * 8 + id.xy / tiles, INTERLEAVE);
    if (any(at >= size)) {
        return;
    }
    var surface = surface_load(screen_pixel(at, size));
    var value = vec4f(0.0);
    if (surface.hit) {
        surface.pixel = at;
        surface.image_size = size;
        surface.layer = id.z;
        surface.turn = select(0.0, turn_at(at), INTERLEAVE);
        value = effect(surface, params);
    }
    store_texel(at, id.z, value);
}
