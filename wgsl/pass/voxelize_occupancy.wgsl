// Sets the bit of every voxel that a triangle overlaps. One thread a tile.

import package::common::triangle_box::{triangle_box, column_range, column_cell_overlaps, unswizzle};
import package::common::tiles::triangle_voxel;
import package::common::tile_walk::{tile_ranks, tile_triangle, tile_columns};
import package::common::grid::{cell_word, cell_bit};
import package::common::frame::frame;
import package::common::fragment::fragment_at;
import package::common::material::{materials, base_color, HAS_ALPHA_MASK};
import package::common::mesh::{vertices, triangle_indices};
import package::common::dispatch::dispatch_index;

@group(1) @binding(0) var<storage, read_write> occupancy: array<atomic<u32>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let tile = dispatch_index(id, 64);
    if (tile >= tile_ranks[frame.triangle_count]) {
        return;
    }
    let triangle = tile_triangle(tile);
    let v = triangle_voxel(triangle);
    let b = triangle_box(v);
    let columns = tile_columns(b, tile, triangle);
    for (var y = columns.first.y; y <= columns.last.y; y++) {
        for (var x = columns.first.x; x <= columns.last.x; x++) {
            let range = column_range(b, vec2i(x, y));
            for (var z = range.x; z <= range.y; z++) {
                if (!column_cell_overlaps(b, vec3i(x, y, z))) {
                    continue;
                }
                let cell = unswizzle(vec3u(vec3i(x, y, z)), b.axis);
                if (HAS_ALPHA_MASK) {
                    let material = materials[vertices[triangle_indices(triangle).x].material];
                    let f = fragment_at(triangle, v, vec3f(cell) + 0.5);
                    if (material.alpha_cutoff > 0.0 && base_color(material, f.uv, f.lod).a < material.alpha_cutoff) {
                        continue;
                    }
                }
                atomicOr(&occupancy[cell_word(cell, 0)], 1u << cell_bit(cell));
            }
        }
    }
}
