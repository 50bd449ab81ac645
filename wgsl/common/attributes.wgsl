// A voxel's attributes, decoded from their fixed-point sums: weight, weight of double-sided surfaces, reflectance (one
// packed word unless it is summed), the normals' positive and negative parts, emission, and last, where it counts, the
// area that triangles cover.

import package::common::conflict::{CONFLICT, CONFLICT_SUM, unpack_reflectance};
import package::common::grid::grid;

var<storage, read> attributes: array<u32>;

override ATTRIBUTE_STRIDE: u32 = 14;
override HAS_VOXEL_EMISSION: bool = true;
override HAS_COVERAGE: bool = false;

struct VoxelSurface {
    // Reflectance of the surfaces in the voxel.
    albedo: vec3f,
    // Unit mean normal; zero where opposite surfaces cancel.
    normal: vec3f,
    // Share of the voxel's surfaces that are double-sided.
    double_sided: f32,
    // Coverage seen by an observer at +x, +y, +z, and at −x, −y, −z: [0, 1]. Surfaces cover from their front.
    front: vec3f,
    back: vec3f,
    // W·m⁻²·sr⁻¹
    emission: vec3f,
    // Of level 0, [0, 1].
    opacity: f32,
}

fn attribute_vector(first: u32) -> vec3f {
    return vec3f(f32(attributes[first]), f32(attributes[first + 1]), f32(attributes[first + 2]));
}

fn voxel_surface(slot: u32) -> VoxelSurface {
    let first = slot * ATTRIBUTE_STRIDE;
    let per_weight = 1.0 / max(f32(attributes[first]), 1.0);
    var s: VoxelSurface;
    s.double_sided = f32(attributes[first + 1]) * per_weight;
    s.albedo = attribute_vector(first + 2) * per_weight;
    if (CONFLICT != CONFLICT_SUM) {
        s.albedo = unpack_reflectance(attributes[first + 2]);
    }
    let positive = attribute_vector(first + 5) * per_weight;
    let negative = attribute_vector(first + 8) * per_weight;
    let sum = positive - negative;
    let size = length(sum);
    // Below this the mean says nothing of any one surface.
    s.normal = select(vec3f(0.0), sum / size, size > 0.1);
    // A plane of normal n crosses |n|₁ voxels for each face that it covers, so each face of a voxel that it crosses
    // is covered by |nᵢ|·|n|₁ at most.
    let both = positive + negative;
    let crossing = both.x + both.y + both.z;
    let other = s.double_sided * both;
    s.front = saturate(max(positive, other) * crossing);
    s.back = saturate(max(negative, other) * crossing);
    s.opacity = 1.0;
    if (HAS_COVERAGE) {
        s.opacity = min(f32(attributes[first + ATTRIBUTE_STRIDE - 1]) / grid.attribute_scale, 1.0);
    }
    if (HAS_VOXEL_EMISSION) {
        s.emission = attribute_vector(first + 11) * per_weight * grid.emission_max;
    }
    return s;
}
