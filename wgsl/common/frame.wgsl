// What every pass may know of the frame. Positions are in world units relative to the grid's centre,
// so that scenes far from the origin keep their precision; `_voxel` positions count voxels from the
// grid's lowest corner.

struct Frame {
    view_projection: mat4x4f,
    // Camera rays: forward + x·right + y·up with x, y in [-1, 1]; right and up carry the half-angles' tangents.
    eye: vec3f,
    near: f32,
    forward: vec3f,
    light_count: u32,
    right: vec3f,
    // Emission that counts as 1.0, W·m⁻²·sr⁻¹.
    emission_max: f32,
    up: vec3f,
    level_count: u32,
    grid_min: vec3f,
    voxel_size: f32,
    grid_size: vec3u,
    texture_size: u32,
    // Radiance from outside the scene, W·m⁻²·sr⁻¹.
    sky: vec3f,
    // Fixed-point units per 1.0 of an attribute; chosen so that no sum can overflow.
    attribute_scale: f32,
    screen: vec2u,
    padding: vec2u,
    // First word of each level in the occupancy bitmask, four levels a vector.
    level_words: array<vec4u, 4>,
}

var<uniform> frame: Frame;

fn to_voxel(position: vec3f) -> vec3f {
    return (position - frame.grid_min) / frame.voxel_size;
}

fn from_voxel(p_voxel: vec3f) -> vec3f {
    return frame.grid_min + p_voxel * frame.voxel_size;
}
