// What each voxel of level 0 shows of its attributes.

import package::common::attributes::voxel_surface;
import package::common::dispatch::dispatch_index;
import package::pass::shown_voxel::{ShownVoxel, pack_shown_normal, params, CHANNEL_ALBEDO, CHANNEL_NORMAL, CHANNEL_EMISSION};
import package::common::voxels::level_cell;

var<storage, read_write> shown_voxels: array<ShownVoxel>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let surface = voxel_surface(slot);
    var color = vec3f(1.0);
    switch params.channel {
        case CHANNEL_ALBEDO: { color = surface.albedo; }
        case CHANNEL_NORMAL: { color = surface.normal; }
        case CHANNEL_EMISSION: { color = surface.emission; }
        default: {}
    }
    shown_voxels[slot] = ShownVoxel(color, pack_shown_normal(surface.normal));
}
