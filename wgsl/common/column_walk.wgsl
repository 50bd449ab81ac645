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

// Between two columns, both included.
fn visit_columns(visitor: Visitor, b: TriangleBox, first: vec2i, last: vec2i) {
    for (var y = first.y; y <= last.y; y++) {
        for (var x = first.x; x <= last.x; x++) {
            visit_column(visitor, b, vec2i(x, y));
        }
    }
}
