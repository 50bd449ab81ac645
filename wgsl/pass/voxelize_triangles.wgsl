// A thread a triangle (RAU §4.1.1), which walks all its rows or leaves it to others.

import package::common::bands::{band_count, triangle_voxel};
import package::common::column_walk::visit_rows;
import package::common::dispatch::dispatch_index;
import package::common::mesh::triangle_range;
import package::common::triangle_box::{TriangleBox, triangle_box};
import package::visitor::visitor;

var<storage, read_write> item_counts: array<u32>;

// What is left to others: nothing; triangles of several bands, a band an item; large triangles, each an item.
override DEFER: u32 = 0;
const DEFER_BANDS = 1u;
const DEFER_LARGE = 2u;
// Projected area from which a triangle is large, voxel².
override CUTOFF: f32 = 4.0;
// Whether the items are still to be counted.
override COUNTS: bool = true;

fn items(b: TriangleBox) -> u32 {
    if (any(b.cell_min > b.cell_max)) {
        return 0;
    }
    if (DEFER == DEFER_BANDS) {
        let bands = band_count(b);
        return select(0u, bands, bands > 1);
    }
    return select(0u, 1u, DEFER == DEFER_LARGE && b.area > CUTOFF);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let triangle = dispatch_index(id, 64);
    if (triangle >= triangle_range.count) {
        // One past the last holds the total.
        if (COUNTS && DEFER != 0 && triangle == triangle_range.count) {
            item_counts[triangle_range.item_first + triangle] = 0;
        }
        return;
    }
    let v = triangle_voxel(triangle);
    let b = triangle_box(v);
    let left = items(b);
    if (COUNTS && DEFER != 0) {
        item_counts[triangle_range.item_first + triangle] = left;
    }
    if (left == 0) {
        visit_rows(visitor(triangle, v, b.axis), b, b.cell_min.y, b.cell_max.y);
    }
}
