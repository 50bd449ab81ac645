// Runs an effect over the screen.

import package::common::surface::surface_load;
import package::effect::{Params, effect};

@group(3) @binding(0) var<uniform> params: Params;
@group(3) @binding(1) var image: texture_storage_2d_array<rgba16float, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (any(id.xy >= textureDimensions(image))) {
        return;
    }
    var surface = surface_load(id.xy);
    var value = vec4f(0.0);
    if (surface.hit) {
        surface.layer = id.z;
        value = effect(surface, params);
    }
    textureStore(image, id.xy, id.z, value);
}
