// One level of the volume from the level below, for the parents of occupied cells only (RAU §5.4).

import package::common::dispatch::dispatch_index;
import package::common::step::step_params;
import package::common::voxels::level_cell;
import package::format::mipmap::voxel_mipmap;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    var cell: vec3u;
    if (level_cell(dispatch_index(id, 64), step_params.level, &cell)) {
        voxel_mipmap(cell, step_params.level);
    }
}
