// What triangles leave in a voxel for its sheets: the largest words and bits, the same whatever the order.

import package::common::front::{FRONTS, Facet, axis_squares, facet, front_point, pack_front, side_fronts};
import package::common::sheet::{ALL_SQUARES, SQUARES, TWO_SIDED};
import package::common::triangle_box::swizzle;

// Of each voxel as common/front.wgsl says.
var<storage, read_write> fronts: array<atomic<u32>>;


// How far inside a triangle's edge from a to b a square lies with all of it, times the edge's length; negative where some of it is
// outside. `facing` is positive where the corners turn from x to y.
fn inside_edge(a: vec2f, b: vec2f, facing: f32, centre: vec2f, half_side: f32) -> f32 {
    let along = b - a;
    let at = sign(facing) * (along.x * (centre.y - a.y) - along.y * (centre.x - a.x));
    return at - half_side * (abs(along.x) + abs(along.y));
}

fn is_inside(f: Facet, centre: vec2f, half_side: f32) -> bool {
    return inside_edge(f.corners[0], f.corners[1], f.facing, centre, half_side) >= 0.0
        && inside_edge(f.corners[1], f.corners[2], f.facing, centre, half_side) >= 0.0
        && inside_edge(f.corners[2], f.corners[0], f.facing, centre, half_side) >= 0.0;
}

// The squares whose middles a triangle covers, and those below.
fn covered_squares(f: Facet) -> u32 {
    if (is_inside(f, vec2f(0.0), 0.5)) {
        return ALL_SQUARES;
    }
    var covered = 0u;
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        let middle = (vec2f(vec2u(i % SQUARES, i / SQUARES)) + 0.5) / f32(SQUARES) - 0.5;
        covered |= select(0u, 1u << i, is_inside(f, middle, 0.0));
    }
    return covered;
}

// A triangle where it may be in front of others in a voxel. Corners are voxels; the axis is the one that the normal is nearest to;
// `nearest` is the triangle's point nearest the voxel's middle.
fn add_front(corners: array<vec3f, 3>, axis: u32, two_sided: bool, nearest: vec3f, triangle: u32, cell: vec3u, slot: u32) {
    let f = facet(corners, axis, cell);
    if (f.facing == 0.0) {
        return;
    }
    let towards = sign(f.facing);
    let first = side_fronts(slot, 2 * axis + select(1u, 0u, f.facing > 0.0));
    let squares = covered_squares(f);
    var covers = false;
    for (var i = 0u; i < FRONTS; i++) {
        let at = front_point(i);
        let height = f.height + dot(f.slope, at);
        if (abs(height) <= 0.5 && (squares == ALL_SQUARES || is_inside(f, at, 0.0))) {
            covers = true;
            atomicMax(&fronts[first + i], pack_front(true, towards * height, triangle));
        }
    }
    if (!covers) {
        // Too small or too near the voxel's edge for any of the points: it counts where nothing covers them.
        let at = swizzle(nearest - vec3f(cell) - 0.5, axis);
        let i = select(0u, 1u, at.x > 0.0) + select(0u, 2u, at.y > 0.0);
        atomicMax(&fronts[first + i], pack_front(false, towards * at.z, triangle));
    }
    atomicOr(&fronts[axis_squares(slot, axis)], squares | select(0u, TWO_SIDED, two_sided));
}
