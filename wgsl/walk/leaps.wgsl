// A ray through the occupancy bitmask by leaps. Each block of 4 × 4 × 4 cells knows how many blocks away the next one is that holds
// an occupied cell: the ray passes the cube of empty blocks around it at once. In a block that holds one it goes from cell to cell by
// whole numbers (Amanatides and Woo, "A Fast Voxel Traversal Algorithm", 1987), or from brick to brick where a word is empty.

import package::common::grid::{BRICK_SHIFT, brick_strides, cell_bit, grid};
import package::common::leap::{BLOCK_SHIFT, leap_at, leap_word};
import package::common::ray::{Passage, Ray, RayHit, against, crossing_of};
import package::common::voxels::{occupancy, rank_in};
import package::meet::meets;

fn first_hit(ray: Ray) -> RayHit {
    var hit: RayHit;
    hit.distance = ray.reach;
    let size = vec3i(grid.size);
    let c = crossing_of(ray, grid.size, 1.0);
    if (c.enter >= min(ray.reach, c.leave)) {
        return hit;
    }
    let facing = against(c);
    let strides = brick_strides(0);
    var passage = Passage(c.enter, 0.0, c.normal);
    var cell = clamp(vec3i(floor(c.origin + passage.enter * c.slope)), vec3i(0), size - 1);
    // A straight line meets at most the sum of the grid's sides.
    let most = grid.size.x + grid.size.y + grid.size.z + 8u;
    for (var i = 0u; i < most; i++) {
        let here = vec3u(cell);
        let block = cell >> vec3u(BLOCK_SHIFT);
        let leap = leap_at(vec3u(block), occupancy[leap_word(vec3u(block))]);
        var index = 0u;
        var word = 0u;
        var low = (block - leap + 1) << vec3u(BLOCK_SHIFT);
        var high = (block + leap) << vec3u(BLOCK_SHIFT);
        if (leap == 0) {
            index = dot(here >> BRICK_SHIFT, strides);
            word = occupancy[index];
            let shift = select(vec3u(0), BRICK_SHIFT, word == 0);
            low = (cell >> shift) << shift;
            high = low + (vec3i(1) << shift);
        }
        let exits = (vec3f(select(low, high, c.forwards)) - c.origin) * c.inverse;
        passage.leave = min(exits.x, min(exits.y, exits.z));
        if (((word >> cell_bit(here)) & 1) != 0 && meets(ray, here, rank_in(index, word, here), passage, &hit)) {
            return hit;
        }
        let along = exits == vec3f(passage.leave);
        let beside = clamp(vec3i(floor(c.origin + passage.leave * c.slope)), low, high - 1);
        cell = select(beside, select(low - 1, high, c.forwards), along);
        if (passage.leave >= ray.reach || any(cell < vec3i(0)) || any(cell >= size)) {
            return hit;
        }
        passage.enter = passage.leave;
        passage.normal = select(vec3f(0.0), facing, along);
    }
    return hit;
}
