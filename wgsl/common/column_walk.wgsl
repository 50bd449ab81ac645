// Shows each voxel that a triangle overlaps in some of its columns to the visitor. All methods of voxelization come
// through here: which thread walks which columns is all that they differ in.

import package::common::triangle_box::{TriangleBox, column_range, column_cell_overlaps, unswizzle};
import package::visitor::{VISIT_TOGETHER, Visitor, visit};

fn visit_column(visitor: Visitor, b: TriangleBox, column: vec2i) {
    let range = column_range(b, column);
    for (var z = range.x; z <= range.y; z++) {
        let cell = vec3i(column, z);
        if (column_cell_overlaps(b, cell)) {
            visit(visitor, unswizzle(vec3u(cell), b.axis));
        }
    }
}

// Between two columns, both included. Loops end at their foot, since a software device goes through a loop's body until
// all of its lanes have left, and once more where they leave at its head; where a visit is long, lanes search for
// their next voxel apart from it, so that they visit together.
fn visit_columns(visitor: Visitor, b: TriangleBox, first: vec2i, last: vec2i) {
    var column = first;
    var z = 0;
    var top = -1;
    loop {
        var cell: vec3i;
        var found: bool;
        loop {
            if (z > top && all(column <= last)) {
                let range = column_range(b, column);
                z = range.x;
                top = range.y;
            }
            cell = vec3i(column, z);
            found = z <= top && column_cell_overlaps(b, cell);
            z++;
            let ends = z > top;
            let row_ends = ends && column.x >= last.x;
            column = select(column, select(column + vec2i(1, 0), vec2i(first.x, column.y + 1), row_ends), ends);
            if (found || !VISIT_TOGETHER || column.y > last.y) {
                break;
            }
        }
        if (found) {
            visit(visitor, unswizzle(vec3u(cell), b.axis));
        }
        if (column.y > last.y) {
            break;
        }
    }
}
