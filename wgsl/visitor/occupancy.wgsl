// What is done with each voxel that a triangle overlaps: its bit is set.

import package::common::fragment::{Corners, corners_of, fragment_at};
import package::common::grid::{cell_word, cell_bit};
import package::common::material::{Material, materials, base_color, HAS_ALPHA_MASK};

@group(1) @binding(0) var<storage, read_write> occupancy: array<atomic<u32>>;

// Whether a visit takes longer than to find the next voxel.
const VISIT_TOGETHER = false;

struct Visitor {
    corners: Corners,
    material: Material,
}

fn visitor(triangle: u32, v: array<vec3f, 3>) -> Visitor {
    var o: Visitor;
    if (HAS_ALPHA_MASK) {
        o.corners = corners_of(triangle, v);
        o.material = materials[o.corners.material];
    }
    return o;
}

fn visit(visitor: Visitor, cell: vec3u) {
    if (HAS_ALPHA_MASK) {
        let f = fragment_at(visitor.corners, vec3f(cell) + 0.5);
        if (base_color(visitor.material, f.uv, f.lod).a < visitor.material.alpha_cutoff) {
            return;
        }
    }
    atomicOr(&occupancy[cell_word(cell, 0)], 1u << cell_bit(cell));
}
