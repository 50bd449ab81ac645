// Writes every active voxel's radiance into level 0 of the volume, by the storage format's own store.

import package::common::attributes::voxel_surface;
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::format::store::voxel_store;

var<storage, read> slot_radiance: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (level_cell(slot, 0, &cell)) {
        let surface = voxel_surface(slot);
        voxel_store(cell, slot_radiance[slot].rgb, surface.normal, surface.opacity);
    }
}
