// Work that a triangle's own thread leaves to others. `item_ranks` holds the number of items before each triangle, those
// with an alpha mask last, and the total at its end: an item is a band of the triangle's rows of columns in `balanced`, the whole triangle in `hybrid`.

import package::common::grid::to_voxel;
import package::common::mesh::{vertices, triangle_indices, triangle_range};
import package::common::triangle_box::TriangleBox;

var<storage, read> item_ranks: array<u32>;

// Columns that a band should have.
const BAND_COLUMNS = 32.0;
// Most bands of a triangle: so few that those of all can be counted.
override MOST_BANDS: u32 = 512;

fn triangle_voxel(triangle: u32) -> array<vec3f, 3> {
    let i = triangle_indices(triangle);
    return array(to_voxel(vertices[i.x].position), to_voxel(vertices[i.y].position), to_voxel(vertices[i.z].position));
}

// How many bands a triangle is worth, at least one. It has about as many columns as area and, along its edges, sides.
fn band_count(b: TriangleBox) -> u32 {
    let sides = b.cell_max.xy - b.cell_min.xy + 1;
    let columns = min(b.area, f32(sides.x * sides.y)) + f32(sides.x + sides.y);
    return clamp(u32(columns / BAND_COLUMNS), 1, min(u32(sides.y), MOST_BANDS));
}

// The rows of a band, inclusive.
fn band_rows(b: TriangleBox, band: u32, bands: u32) -> vec2i {
    let rows = u32(b.cell_max.y - b.cell_min.y + 1);
    return b.cell_min.y + vec2i(vec2u(band, band + 1) * rows / bands) - vec2i(0, 1);
}

// The range's first item, and how many it has.
fn item_range() -> vec2u {
    let first = item_ranks[triangle_range.item_first];
    return vec2u(first, item_ranks[triangle_range.item_first + triangle_range.count] - first);
}

// The triangle of the range that an item belongs to: the last whose rank is not above it.
fn item_triangle(item: u32) -> u32 {
    var low = 0u;
    var high = triangle_range.count;
    while (high - low > 1) {
        let middle = (low + high) / 2;
        if (item_ranks[triangle_range.item_first + middle] <= item) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}
