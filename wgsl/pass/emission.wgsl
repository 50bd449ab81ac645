// What emissive surfaces emit, alone: the first volume, from which voxels gather their light, and past which the
// sky's, once.

import package::common::attributes::voxel_surface;
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;

var<storage, read_write> direct: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (level_cell(slot, 0, &cell)) {
        direct[slot] = vec4f(voxel_surface(slot).emission, 1.0);
    }
}
