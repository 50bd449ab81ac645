// Work that a triangle's own thread leaves to others. `tile_ranks` holds the number of items before each triangle, and
// the total at its end: an item is a tile of the triangle's columns in `balanced`, the whole triangle in `hybrid`.

import package::common::frame::to_voxel;
import package::common::mesh::{vertices, triangle_indices, triangle_range};
import package::common::triangle_box::TriangleBox;

@group(1) @binding(9) var<storage, read> tile_ranks: array<u32>;

// Columns along a tile's side.
override TILE: i32 = 8;

fn triangle_voxel(triangle: u32) -> array<vec3f, 3> {
    let i = triangle_indices(triangle);
    return array(to_voxel(vertices[i.x].position), to_voxel(vertices[i.y].position), to_voxel(vertices[i.z].position));
}

fn tile_grid(b: TriangleBox) -> vec2u {
    if (any(b.cell_min > b.cell_max)) {
        return vec2u(0);
    }
    return vec2u((b.cell_max.xy - b.cell_min.xy) / TILE + 1);
}

// The triangle that an item belongs to: the last whose rank is not above it.
fn item_triangle(item: u32) -> u32 {
    var low = 0u;
    var high = triangle_range.count;
    while (high - low > 1) {
        let middle = (low + high) / 2;
        if (tile_ranks[middle] <= item) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}
