// Each voxel's planes from what its triangles added up, packed (see common/plane.wgsl).

import package::common::dispatch::dispatch_index;
import package::common::plane::{Plane, pack_plane};
import package::common::voxels::level_cell;

// For each axis: weight, height, two slopes; last a bit for each side shown.
var<storage, read> plane_sums: array<u32>;
var<storage, read_write> planes: array<u32>;

override PLANE_STRIDE: u32 = 13;

fn mean_plane(first: u32, shown: u32) -> u32 {
    let weight = plane_sums[first];
    if (weight == 0) {
        return 0;
    }
    let sums = vec3f(vec3u(plane_sums[first + 1], plane_sums[first + 2], plane_sums[first + 3]));
    let mean = sums / f32(weight);
    return pack_plane(Plane(3.0 * mean.x - 1.5, 2.0 * mean.yz - 1.0, vec2((shown & 1) != 0, (shown & 2) != 0)));
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let first = slot * PLANE_STRIDE;
    let shown = plane_sums[first + 12];
    for (var axis = 0u; axis < 3; axis++) {
        planes[3 * slot + axis] = mean_plane(first + 4 * axis, (shown >> (2 * axis)) & 3);
    }
}
