// A voxel's attributes, decoded from their fixed-point sums.

import package::common::frame::frame;

@group(1) @binding(4) var<storage, read> attributes: array<u32>;

override ATTRIBUTE_STRIDE: u32 = 10;
override HAS_VOXEL_EMISSION: bool = true;

struct VoxelSurface {
    // Reflectance of the surfaces in the voxel.
    albedo: vec3f,
    // Unit mean normal; zero where opposite surfaces cancel.
    normal: vec3f,
    // W·m⁻²·sr⁻¹
    emission: vec3f,
}

fn voxel_surface(slot: u32) -> VoxelSurface {
    let first = slot * ATTRIBUTE_STRIDE;
    let weight = max(f32(attributes[first]), 1.0);
    var s: VoxelSurface;
    s.albedo = vec3f(f32(attributes[first + 1]), f32(attributes[first + 2]), f32(attributes[first + 3])) / weight;
    s.normal = vec3f(
        f32(i32(attributes[first + 4])),
        f32(i32(attributes[first + 5])),
        f32(i32(attributes[first + 6])),
    ) / weight * (frame.attribute_scale / frame.normal_scale);
    let size = length(s.normal);
    // Below this the mean says nothing of any one surface.
    s.normal = select(vec3f(0.0), s.normal / size, size > 0.1);
    if (HAS_VOXEL_EMISSION) {
        s.emission = vec3f(f32(attributes[first + 7]), f32(attributes[first + 8]), f32(attributes[first + 9]))
            / weight * frame.emission_max;
    }
    return s;
}
