// Shadow maps: a layer for each directional and spot light, six for each point light.

import package::common::light::{Light, LIGHT_POINT};

var shadow_maps: texture_depth_2d_array;
var shadow_sampler: sampler_comparison;
// One for each layer that a texture can have.
var<uniform> shadow_matrices: array<mat4x4f, 256>;

fn cube_face(v: vec3f) -> i32 {
    let a = abs(v);
    if (a.x >= a.y && a.x >= a.z) { return select(1, 0, v.x > 0.0); }
    if (a.y >= a.z) { return select(3, 2, v.y > 0.0); }
    return select(5, 4, v.z > 0.0);
}

// Share of the light that arrives, [0, 1]; 1 outside the map.
fn shadow_map_visibility(light: Light, position: vec3f) -> f32 {
    var layer = light.shadow_layer;
    if (light.kind == LIGHT_POINT) {
        layer += cube_face(position - light.position);
    }
    let clip = shadow_matrices[layer] * vec4f(position, 1.0);
    if (clip.w <= 0.0) {
        return 1.0;
    }
    let ndc = clip.xyz / clip.w;
    if (any(abs(ndc.xy) > vec2f(1.0)) || ndc.z > 1.0 || ndc.z < 0.0) {
        return 1.0;
    }
    let uv = ndc.xy * vec2f(0.5, -0.5) + 0.5;
    return textureSampleCompareLevel(shadow_maps, shadow_sampler, uv, layer, ndc.z);
}
