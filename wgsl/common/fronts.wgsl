// What triangles leave in a voxel for its sheets: the largest words and bits, the same whatever the order.

import package::common::front::{CUT, FRONTS, Facet, axis_squares, axis_touched, front_point, pack_front, pack_small, side_fronts};
import package::common::sheet::{TWO_SIDED, square_bit};
import package::common::squares::Remains;
import package::common::triangle_box::swizzle;

// Of each voxel as common/front.wgsl says.
var<storage, read_write> fronts: array<atomic<u32>>;

// A triangle where it may be in front of others in a voxel, and what it has left there. The axis is the one that the normal is nearest to;
// `nearest` is the triangle's point nearest the voxel's middle, from there.
fn add_front(f: Facet, axis: u32, remains: Remains, two_sided: bool, nearest: vec3f, triangle: u32, slot: u32) {
    if (f.facing == 0.0) {
        return;
    }
    let towards = sign(f.facing);
    let first = side_fronts(slot, 2 * axis + select(1u, 0u, f.facing > 0.0));
    var covers = false;
    for (var i = 0u; i < FRONTS; i++) {
        let at = front_point(i);
        let height = f.height + dot(f.slope, at);
        if (abs(height) <= 0.5 && (remains.squares & square_bit(at)) != 0) {
            covers = true;
            atomicMax(&fronts[first + i], pack_front(towards * height, triangle));
        }
    }
    if (!covers) {
        // Too small or too near the voxel's edge for any of the points: it counts where nothing covers them.
        let at = swizzle(nearest, axis);
        let i = select(0u, 1u, at.x > 0.0) + select(0u, 2u, at.y > 0.0);
        atomicMax(&fronts[first + i], pack_small(f, triangle));
    }
    atomicOr(&fronts[axis_squares(slot, axis)], remains.squares | select(0u, TWO_SIDED, two_sided));
    atomicOr(&fronts[axis_touched(slot, axis)], remains.touched | select(0u, CUT, remains.cut));
}
