// Shows each voxel that a triangle overlaps in some of its columns to the visitor. All methods of voxelization come
// through here: which thread walks which columns is all that they differ in.

import package::common::triangle_box::{TriangleBox, column_range, row_at};
import package::visitor::{Visitor, leave, visit};

fn visit_column(visitor: Visitor, b: TriangleBox, column: vec2i) {
    var guest = visitor;
    let row = row_at(b, column.y);
    let range = column_range(b, row, column);
    var z = range.x;
    while (z <= range.y && column.x >= row.columns.x && column.x <= row.columns.y) {
        z = visit(&guest, vec3i(column, z), range.y);
    }
    leave(guest);
}

// Rows of columns, both included. One loop, which ends at its foot, over all that is visited: a software device goes through
// a loop's body until all of its lanes have left, and once more where they leave at its head.
fn visit_rows(visitor: Visitor, b: TriangleBox, first: i32, last: i32) {
    if (first > last) {
        return;
    }
    var guest = visitor;
    var y = first;
    var row = row_at(b, y);
    var x = row.columns.x;
    var range = column_range(b, row, vec2i(x, y));
    loop {
        let found = x <= row.columns.y && range.x <= range.y;
        if (found) {
            range.x = visit(&guest, vec3i(x, y, range.x), range.y);
        }
        if (!found || range.x > range.y) {
            x++;
            if (x > row.columns.y) {
                y++;
                row = row_at(b, y);
                x = row.columns.x;
            }
            range = column_range(b, row, vec2i(x, y));
        }
        if (y > last) {
            break;
        }
    }
    leave(guest);
}
