// What is done with each voxel that a triangle overlaps: its bit is set.

import package::common::grid::{cell_word, cell_bit};
import package::common::fragment::{Corners, corners_of, fragment_at};
import package::common::material::{Material, materials, base_color, HAS_ALPHA_MASK};

@group(1) @binding(0) var<storage, read_write> occupancy: array<atomic<u32>>;

struct Visitor {
    corners: Corners,
}

fn visitor(triangle: u32, v: array<vec3f, 3>) -> Visitor {
    return Visitor(corners_of(triangle, v));
}

fn visit(visitor: Visitor, cell: vec3u) {
    var covers = true;
    if (HAS_ALPHA_MASK) {
        let material = materials[visitor.corners.material];
        // A loop, since a software device runs both sides of an `if`, and leaves a loop that no thread enters.
        for (var masked = material.alpha_cutoff > 0.0; masked; masked = false) {
            let f = fragment_at(visitor.corners, vec3f(cell) + 0.5);
            covers = base_color(material, f.uv, f.lod).a >= material.alpha_cutoff;
        }
    }
    if (covers) {
        atomicOr(&occupancy[cell_word(cell, 0)], 1u << cell_bit(cell));
    }
}
