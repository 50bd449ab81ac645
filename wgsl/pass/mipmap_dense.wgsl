// One level of the volume from the level below, for every cell: what active-voxel lists spare (RAU §5.4).

import package::common::grid::level_size;
import package::common::step::step_params;
import package::format::mipmap::voxel_mipmap;

@compute @workgroup_size(4, 4, 4)
fn main(@builtin(global_invocation_id) cell: vec3u) {
    if (all(cell < level_size(step_params.level))) {
        voxel_mipmap(cell, step_params.level);
    }
}
