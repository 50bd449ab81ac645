// What the volume holds of each cell of a level, as cones find it at the cell's centre.

import package::common::dispatch::dispatch_index;
import package::common::camera::camera;
import package::common::grid::{grid, to_voxel};
import package::pass::shown_voxel::{ShownVoxel, params, CHANNEL_LIT, CHANNEL_OPACITY};
import package::common::step::step_params;
import package::common::voxels::{level_cell, levels};
import package::format::sample::voxel_sample;

var<storage, read_write> shown_voxels: array<ShownVoxel>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(index, step_params.level, &cell)) {
        return;
    }
    let p_voxel = (vec3f(cell) + 0.5) * exp2(f32(step_params.level));
    // Whoever is at that side looks the other way.
    var direction = -normalize(params.direction);
    if (params.channel == CHANNEL_LIT) {
        direction = normalize(p_voxel - to_voxel(camera.eye));
    }
    let found = voxel_sample(p_voxel / vec3f(grid.size), f32(step_params.level), direction);
    let radiance = found.rgb / max(found.a, 1e-6);
    let color = select(radiance, vec3f(found.a), params.channel == CHANNEL_OPACITY);
    shown_voxels[levels[step_params.level].first + index].color = color;
}
