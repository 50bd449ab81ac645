// The camera. Positions are in world units relative to the scene's origin, the centre of the first grid, so that scenes
// far from the world's origin keep their precision.

struct Camera {
    view_projection: mat4x4f,
    // Camera rays: forward + x·right + y·up with x, y in [-1, 1]; right and up carry the half-angles' tangents.
    eye: vec3f,
    near: f32,
    forward: vec3f,
    // Side of a voxel of the first grid, world units: the scale by which distances on the screen are judged.
    voxel_size: f32,
    right: vec3f,
    padding_right: f32,
    up: vec3f,
    padding_up: f32,
    // Pixels of the screen.
    screen: vec2u,
    padding: vec2u,
}

var<uniform> camera: Camera;
