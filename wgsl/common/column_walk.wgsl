// Shows each voxel that a triangle overlaps in some of its columns to the visitor. All methods of voxelization come
// through here: which thread walks which columns is all that they differ in.

import package::common::triangle_box::{TriangleBox, column_range, column_cell_overlaps, unswizzle};
import package::visitor::{Visitor, visit};

fn visit_column(visitor: Visitor, b: TriangleBox, column: vec2i) {
    let range = column_range(b, column);
    for (var z = range.x; z <= range.y; z++) {
        let cell = vec3i(column, z);
        if (column_cell_overlaps(b, cell)) {
            visit(visitor, unswizzle(vec3u(cell), b.axis));
        }
    }
}

// Between two columns, both included. One loop that ends at its foot: a software device goes through a loop's body until
// all of its lanes have left, and once more where they leave at its head.
fn visit_columns(visitor: Visitor, b: TriangleBox, first: vec2i, last: vec2i) {
    var column = first;
    var z = 0;
    var top = -1;
    loop {
        if (z > top && all(column <= last)) {
            let range = column_range(b, column);
            z = range.x;
            top = range.y;
        }
        let cell = vec3i(column, z);
        if (z <= top && column_cell_overlaps(b, cell)) {
            visit(visitor, unswizzle(vec3u(cell), b.axis));
        }
        z++;
        if (z > top) {
            column.x++;
            if (column.x > last.x) {
                column = vec2i(first.x, column.y + 1);
            }
        }
        if (column.y > last.y) {
            break;
        }
    }
}
