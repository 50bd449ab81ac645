// How many tiles each triangle has.

import package::common::frame::frame;
import package::common::triangle_box::triangle_box;
import package::common::tiles::{triangle_voxel, tile_grid};
import package::common::dispatch::dispatch_index;

@group(1) @binding(8) var<storage, read_write> tile_ranks: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let triangle = dispatch_index(id, 64);
    if (triangle > frame.triangle_count) {
        return;
    }
    var tiles = 0u;
    if (triangle < frame.triangle_count) {
        let grid = tile_grid(triangle_box(triangle_voxel(triangle)));
        tiles = grid.x * grid.y;
    }
    tile_ranks[triangle] = tiles;
}
