// The scene's triangles, one buffer for all of them.


struct Vertex {
    position: vec3f,
    material: u32,
    // Octahedral.
    normal: u32,
    tangent: u32,
    uv: vec2f,
}

var<storage, read> vertices: array<Vertex>;
var<storage, read> indices: array<u32>;

// Triangles that a pass is about: of all, of those that never move, or of those that may, which come last, those with an
// alpha mask or those without.
struct TriangleRange {
    first: u32,
    count: u32,
    // Where in the list of items its first triangle is.
    item_first: u32,
}

var<uniform> triangle_range: TriangleRange;

// Triangles count from the range's first.
fn triangle_indices(triangle: u32) -> vec3u {
    let i = 3 * (triangle_range.first + triangle);
    return vec3u(indices[i], indices[i + 1], indices[i + 2]);
}
