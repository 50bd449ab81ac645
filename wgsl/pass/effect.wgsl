// Runs an effect for every texel of its image.

import package::common::leaning::leaning;
import package::common::share::share_at;
import package::effect::{Params, effect};
import package::seen::surface_seen;
import package::texel::{image, store_texel};

var<uniform> params: Params;

// Texels along each side of a tile that share out the directions; `interleave` then takes their mean.
override INTERLEAVE: u32 = 1;
// Whether the image's second half of layers holds from where the light of the first half's comes.
override LEANS: bool = false;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    // In tiles of 8 × 8 all threads of a workgroup trace the same share, each in another tile: traces keep together.
    let tiles = (size + 7) / 8;
    let at = select(id.xy, (id.xy % tiles) * 8 + id.xy / tiles, INTERLEAVE == 8);
    if (any(at >= size)) {
        return;
    }
    var surface = surface_seen(at, size);
    var value = vec4f(0.0);
    if (surface.hit) {
        surface.pixel = at;
        surface.image_size = size;
        surface.layer = id.z;
        surface.share = share_at(at, INTERLEAVE);
        value = effect(surface, params);
    }
    store_texel(at, id.z, value);
    if (LEANS) {
        store_texel(at, id.z + textureNumLayers(image) / 2, leaning);
    }
}
