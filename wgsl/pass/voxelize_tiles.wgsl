// A thread a tile of a triangle that has several.

import package::common::column_walk::visit_columns;
import package::common::dispatch::dispatch_index;
import package::common::mesh::triangle_range;
import package::common::tiles::{TILE, item_triangle, tile_grid, tile_ranks, triangle_voxel};
import package::common::triangle_box::triangle_box;
import package::visitor::visitor;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let item = dispatch_index(id, 64);
    if (item >= tile_ranks[triangle_range.count]) {
        return;
    }
    let triangle = item_triangle(item);
    let v = triangle_voxel(triangle);
    let b = triangle_box(v);
    let tile = item - tile_ranks[triangle];
    let width = tile_grid(b).x;
    let first = b.cell_min.xy + vec2i(vec2u(tile % width, tile / width)) * TILE;
    visit_columns(visitor(triangle, v), b, first, min(first + (TILE - 1), b.cell_max.xy));
}
