// What a cell of a coarser level shows: the mean of its occupied children.

import package::common::dispatch::dispatch_index;
import package::pass::shown_voxel::{ShownVoxel, pack_shown_normal, shown_normal, params, CHANNEL_NORMAL};
import package::common::step::step_params;
import package::common::voxels::{cell_rank, is_occupied, level_cell, levels};

var<storage, read_write> shown_voxels: array<ShownVoxel>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(index, step_params.level, &cell)) {
        return;
    }
    var color = vec3f(0.0);
    var normal = vec3f(0.0);
    var count = 0.0;
    for (var i = 0u; i < 8; i++) {
        let child = cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2);
        if (is_occupied(child, step_params.level - 1)) {
            let shown = shown_voxels[cell_rank(child, step_params.level - 1)];
            color += shown.color;
            normal += shown_normal(shown);
            count += 1.0;
        }
    }
    let size = length(normal);
    let unit = select(vec3f(0.0), normal / size, size > 0.1);
    color = select(color / count, unit, params.channel == CHANNEL_NORMAL);
    shown_voxels[levels[step_params.level].first + index] = ShownVoxel(color, pack_shown_normal(unit));
}
