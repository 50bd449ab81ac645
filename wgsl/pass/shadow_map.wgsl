// Depth of the scene from a light, one layer a draw.

import package::common::mesh::vertices;
import package::common::material::{materials, base_color, HAS_ALPHA_MASK};
import package::common::step::step_params;

// One for each layer that a texture can have.
var<uniform> shadow_matrices: array<mat4x4f, 256>;

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) uv: vec2f,
    @location(1) @interpolate(flat) material: u32,
}

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> Varyings {
    let v = vertices[index];
    return Varyings(shadow_matrices[step_params.level] * vec4f(v.position, 1.0), v.uv, v.material);
}

@fragment
fn fragment_main(v: Varyings) {
    let material = materials[v.material];
    if (HAS_ALPHA_MASK && material.alpha_cutoff > 0.0 && base_color(material, v.uv, 0.0).a < material.alpha_cutoff) {
        discard;
    }
}
