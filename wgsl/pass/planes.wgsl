// Each voxel's planes from what its triangles added up, packed (see common/plane.wgsl).

import package::common::dispatch::dispatch_index;
import package::common::plane::{Plane, pack_plane};
import package::common::voxels::level_cell;

// For each axis: weight, height, two slopes, the squares covered and the sides shown.
var<storage, read> plane_sums: array<u32>;
// For each axis.
var<storage, read_write> planes: array<vec2u>;

const PLANE_STRIDE = 15u;

fn mean_plane(first: u32) -> vec2u {
    let weight = plane_sums[first];
    if (weight == 0) {
        return vec2u(0);
    }
    let sums = vec3f(vec3u(plane_sums[first + 1], plane_sums[first + 2], plane_sums[first + 3]));
    let mean = sums / f32(weight);
    return pack_plane(Plane(3.0 * mean.x - 1.5, 2.0 * mean.yz - 1.0, plane_sums[first + 4]));
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    for (var axis = 0u; axis < 3; axis++) {
        planes[3 * slot + axis] = mean_plane(slot * PLANE_STRIDE + 5 * axis);
    }
}
