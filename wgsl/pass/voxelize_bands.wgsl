// A thread a band of a triangle that has several.

import package::common::bands::{band_rows, item_range, item_ranks, item_triangle, triangle_voxel};
import package::common::column_walk::visit_rows;
import package::common::dispatch::dispatch_index;
import package::common::mesh::triangle_range;
import package::common::triangle_box::triangle_box;
import package::visitor::visitor;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let range = item_range();
    if (index >= range.y) {
        return;
    }
    let item = range.x + index;
    let triangle = item_triangle(item);
    let v = triangle_voxel(triangle);
    let b = triangle_box(v);
    let ranks = triangle_range.item_first + triangle;
    let first = item_ranks[ranks];
    let rows = band_rows(b, item - first, item_ranks[ranks + 1] - first);
    visit_rows(visitor(triangle, v, b.axis), b, rows.x, rows.y);
}
