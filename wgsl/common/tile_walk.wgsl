// Finding the triangle and the columns of a tile.

import package::common::frame::frame;
import package::common::triangle_box::TriangleBox;
import package::common::tiles::{TILE, tile_grid};

@group(1) @binding(9) var<storage, read> tile_ranks: array<u32>;

// The triangle that tile number `tile` belongs to: the last whose rank is not above it.
fn tile_triangle(tile: u32) -> u32 {
    var low = 0u;
    var high = frame.triangle_count;
    while (high - low > 1) {
        let middle = (low + high) / 2;
        if (tile_ranks[middle] <= tile) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

struct TileColumns {
    first: vec2i,
    last: vec2i,
}

fn tile_columns(b: TriangleBox, tile: u32, triangle: u32) -> TileColumns {
    let index = tile - tile_ranks[triangle];
    let grid = tile_grid(b);
    let first = b.cell_min.xy + vec2i(vec2u(index % grid.x, index / grid.x)) * TILE;
    return TileColumns(first, min(first + (TILE - 1), b.cell_max.xy));
}
