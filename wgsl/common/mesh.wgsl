// The scene's triangles, one buffer for all of them.


struct Vertex {
    position: vec3f,
    material: u32,
    // Octahedral.
    normal: u32,
    tangent: u32,
    uv: vec2f,
}

@group(0) @binding(1) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(2) var<storage, read> indices: array<u32>;

fn triangle_indices(triangle: u32) -> vec3u {
    return vec3u(indices[3 * triangle], indices[3 * triangle + 1], indices[3 * triangle + 2]);
}
