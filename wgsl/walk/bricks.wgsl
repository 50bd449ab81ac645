// A ray through the occupancy bitmask: cells of every second level by whole numbers (Amanatides and Woo, "A Fast Voxel
// Traversal Algorithm", 1987), down where a cell is occupied and up again where the ray leaves the coarser cell. Where all
// of a word is empty, the ray passes its whole brick.

import package::common::grid::{BRICK_SHIFT, brick_strides, cell_bit, grid, level_first_word, level_size};
import package::common::ray::{Passage, Ray, RayHit, against, crossing_of};
import package::common::voxels::{occupancy, rank_in};
import package::meet::meets;

// Levels between those that a ray looks at: a word's brick is then as large as two cells of the next.
const STRIDE = 2u;
// The coarsest that it looks at.
const TOP = 4u;

fn first_hit(ray: Ray) -> RayHit {
    return first_hit_at(ray, 0);
}

// The first cell of `finest` or, where that is 0, the first surface in one.
fn first_hit_at(ray: Ray, finest: u32) -> RayHit {
    var hit: RayHit;
    hit.distance = ray.reach;
    let size = vec3i(level_size(finest));
    let c = crossing_of(ray, vec3u(size), exp2(f32(finest)));
    if (c.enter >= min(ray.reach, c.leave)) {
        return hit;
    }
    let facing = against(c);
    var passage = Passage(c.enter, 0.0, c.normal);
    var cell = clamp(vec3i(floor(c.origin + passage.enter * c.slope)), vec3i(0), size - 1);
    let top = min(TOP, (grid.level_count - 1 - finest) & ~1u);
    // Near where it begins there may be its own surface.
    var level = 0u;
    var first = level_first_word(finest);
    var strides = brick_strides(finest);
    // A straight line meets at most the sum of the grid's sides; for each cell it goes down and up at most once.
    let most = 2u * (grid.size.x + grid.size.y + grid.size.z) + 8u;
    for (var i = 0u; i < most; i++) {
        let here = vec3u(cell) >> vec3u(level);
        let index = first + dot(here >> BRICK_SHIFT, strides);
        let word = occupancy[index];
        let occupied = ((word >> cell_bit(here)) & 1) != 0;
        if (occupied && level > 0) {
            level -= STRIDE;
            first = level_first_word(level + finest);
            strides = brick_strides(level + finest);
            continue;
        }
        // The box that the ray passes: a cell, or a brick of empty ones.
        let shift = vec3u(level) + select(vec3u(0), BRICK_SHIFT, word == 0);
        let low = vec3i((vec3u(cell) >> shift) << shift);
        let high = low + (vec3i(1) << shift);
        let exits = (vec3f(select(low, high, c.forwards)) - c.origin) * c.inverse;
        passage.leave = min(exits.x, min(exits.y, exits.z));
        if (occupied && meets(ray, here, rank_in(index, word, here), passage, &hit)) {
            return hit;
        }
        let along = exits == vec3f(passage.leave);
        let beside = clamp(vec3i(floor(c.origin + passage.leave * c.slope)), low, high - 1);
        let next = select(beside, select(low - 1, high, c.forwards), along);
        if (passage.leave >= ray.reach || any(next < vec3i(0)) || any(next >= size)) {
            return hit;
        }
        // Up where the coarser cell is left.
        let up = min(level + STRIDE, top);
        if (up != level && any((next >> vec3u(up)) != (cell >> vec3u(up)))) {
            level = up;
            first = level_first_word(level + finest);
            strides = brick_strides(level + finest);
        }
        cell = next;
        passage.enter = passage.leave;
        passage.normal = select(vec3f(0.0), facing, along);
    }
    return hit;
}
