// Runs an effect over the screen.

import package::common::range::in_half_range;
import package::common::surface::surface_load;
import package::common::turn::turn_at;
import package::effect::{Params, effect};

var<uniform> params: Params;
var image: texture_storage_2d_array<rgba16float, write>;

// Whether the pixels of a tile of 4 × 4 share out the directions; `interleave` then takes their mean.
override INTERLEAVE: bool = false;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (any(id.xy >= textureDimensions(image))) {
        return;
    }
    var surface = surface_load(id.xy);
    var value = vec4f(0.0);
    if (surface.hit) {
        surface.layer = id.z;
        surface.turn = select(0.0, turn_at(id.xy), INTERLEAVE);
        value = effect(surface, params);
    }
    textureStore(image, id.xy, id.z, vec4f(in_half_range(value.rgb), value.a));
}
