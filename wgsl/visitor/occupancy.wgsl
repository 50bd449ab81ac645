// What is done with each voxel that a triangle overlaps: its bit is set.

import package::common::fragment::{Corners, corners_of, fragment_at};
import package::common::front::facet;
import package::common::grid::{BRICK_SHIFT, BRICK_BITS, brick_strides};
import package::common::material::{Material, materials, HAS_ALPHA_MASK};
import package::common::squares::remains;
import package::common::triangle_box::{swizzle_cell, unswizzle};

var<storage, read_write> occupancy: array<atomic<u32>>;

struct Visitor {
    axis: u32,
    // The word last visited, and its bits that are still to be set.
    word: u32,
    bits: u32,
    // A brick's layout, swizzled: cells along its sides as powers of two, words from brick to brick, bits from cell to cell.
    shift: vec3u,
    words: vec3u,
    cells: vec3u,
    corners: Corners,
    material: Material,
}

fn visitor(triangle: u32, v: array<vec3f, 3>, axis: u32) -> Visitor {
    var o: Visitor;
    o.axis = axis;
    o.shift = swizzle_cell(BRICK_SHIFT, axis);
    o.words = swizzle_cell(brick_strides(0), axis);
    o.cells = swizzle_cell(BRICK_BITS, axis);
    if (HAS_ALPHA_MASK) {
        o.corners = corners_of(triangle, v);
        o.material = materials[o.corners.material];
    }
    return o;
}

// Sets the bits of the word last visited.
fn leave(visitor: Visitor) {
    if (visitor.bits != 0) {
        atomicOr(&occupancy[visitor.word], visitor.bits);
    }
}

// Visits the voxel of a column, in swizzled cells, and those up to `top` that share its word; says which is next.
fn visit(visitor: ptr<function, Visitor>, cell: vec3i, top: i32) -> i32 {
    let side = (vec3u(1) << (*visitor).shift) - 1;
    var last = min(top, cell.z | i32(side.z));
    if (HAS_ALPHA_MASK) {
        last = cell.z;
        let of_grid = unswizzle(vec3u(cell), (*visitor).axis);
        let nearest = fragment_at((*visitor).corners, vec3f(of_grid) + 0.5);
        let plane = facet((*visitor).corners.v, (*visitor).axis, of_grid);
        if (!remains(plane, (*visitor).corners, nearest, (*visitor).material).there) {
            return cell.z + 1;
        }
    }
    let word = dot(vec3u(cell) >> (*visitor).shift, (*visitor).words);
    let first = dot(vec3u(cell) & side, (*visitor).cells);
    // A bit for each cell along the column.
    let line = select(select(0xfu, 0x1111u, (*visitor).axis == 1), 0x10001u, (*visitor).axis == 2);
    let bits = (line & ((2u << (u32(last - cell.z) * (*visitor).cells.z)) - 1)) << first;
    if (word != (*visitor).word) {
        leave(*visitor);
        (*visitor).word = word;
        (*visitor).bits = 0;
    }
    (*visitor).bits |= bits;
    return last + 1;
}
