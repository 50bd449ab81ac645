// How much there is of what triangles left to others.

import package::common::bands::item_range;
import package::common::dispatch::dispatch_groups;

var<storage, read_write> item_groups: vec4u;

// Triangles to draw, or workgroups of 64 threads with an item each.
override DRAWN: bool = false;

@compute @workgroup_size(1)
fn main() {
    let items = item_range().y;
    if (DRAWN) {
        item_groups = vec4u(3 * items, 1, 0, 0);
    } else {
        item_groups = vec4u(dispatch_groups(items, 64), 0);
    }
}
