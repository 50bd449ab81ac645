// What emissive surfaces emit, alone: the first volume, from which voxels gather their light, and past which the
// sky's, once.

import package::common::attributes::voxel_surface;
import package::common::dispatch::dispatch_index;
import package::common::radiance::pack_radiance;
import package::common::sheet::SIDES;
import package::common::voxels::level_cell;
import package::emitters::SAMPLED;

var<storage, read_write> direct: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (level_cell(slot, 0, &cell)) {
        let emitted = pack_radiance(select(voxel_surface(slot).emission, vec3f(0.0), SAMPLED));
        for (var i = 0u; i < SIDES; i++) {
            direct[SIDES * slot + i] = emitted;
        }
    }
}
