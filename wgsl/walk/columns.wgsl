// A ray through columns of bits (VGI §4.2): down where the cells of a column that the ray passes and those that are occupied have
// one in common, on to the next column and up where they have none. The first of them along the ray is the first hit.

import package::common::columns::{column_count, column_level_first, column_level_words, column_words};
import package::common::grid::{cell_bit, cell_word, grid};
import package::common::ray::{Crossing, Passage, Ray, RayHit, against, crossing_of};
import package::common::voxels::{occupancy, rank_in};
import package::meet::meets;

// A part of a column, between two places along the ray.
struct ColumnPart {
    first_word: u32,
    // Cells along z, both included.
    low: i32,
    high: i32,
}

// Cells that f32 may take for its neighbours: whether they are passed is seen when they are met.
const SLACK = 1e-3;

fn part_of(c: Crossing, first_word: u32, enter: f32, leave: f32) -> ColumnPart {
    let ends = c.origin.z + vec2f(enter, leave) * c.slope.z;
    let most = f32(grid.size.z - 1);
    let low = clamp(min(ends.x, ends.y) - SLACK, 0.0, most);
    let high = clamp(max(ends.x, ends.y) + SLACK, 0.0, most);
    return ColumnPart(first_word, i32(low), i32(high));
}

// The bits of a word that the part passes (VGI figure 6): those of the ray and of the column both.
fn passed(part: ColumnPart, word: i32) -> u32 {
    let low = u32(max(part.low - 32 * word, 0));
    let high = u32(min(part.high - 32 * word, 31));
    return occupancy[part.first_word + u32(word)] & (0xffffffffu << low) & (0xffffffffu >> (31 - high));
}

fn any_passed(part: ColumnPart) -> bool {
    for (var word = part.low >> 5; word <= part.high >> 5; word++) {
        if (passed(part, word) != 0) {
            return true;
        }
    }
    return false;
}

// What is met in a column of level 0 between two places along the ray.
fn meets_in(ray: Ray, c: Crossing, column: vec2u, part: ColumnPart, along: Passage, hit: ptr<function, RayHit>) -> bool {
    let words = 1 + (part.high >> 5) - (part.low >> 5);
    for (var i = 0; i < words; i++) {
        let word = select((part.high >> 5) - i, (part.low >> 5) + i, c.forwards.z);
        var bits = passed(part, word);
        while (bits != 0) {
            let bit = select(firstLeadingBit(bits), firstTrailingBit(bits), c.forwards.z);
            bits &= ~(1u << bit);
            let cell = vec3u(column, u32(32 * word) + bit);
            let near = f32(cell.z) + select(1.0, 0.0, c.forwards.z);
            let far = f32(cell.z) + select(0.0, 1.0, c.forwards.z);
            let planes = (vec2f(near, far) - c.origin.z) * c.inverse.z;
            var passage = Passage(max(along.enter, planes.x), min(along.leave, planes.y), along.normal);
            if (planes.x > along.enter) {
                passage.normal = vec3f(0.0, 0.0, against(c).z);
            }
            if (passage.enter <= passage.leave && passage.enter <= ray.reach) {
                let index = cell_word(cell, 0);
                if (meets(ray, cell, rank_in(index, occupancy[index], cell), passage, hit)) {
                    return true;
                }
            }
        }
    }
    return false;
}

// The first surface.
fn first_hit(ray: Ray) -> RayHit {
    var hit: RayHit;
    hit.distance = ray.reach;
    let c = crossing_of(ray, grid.size, 1.0);
    let end = min(ray.reach, c.leave);
    if (c.enter >= end) {
        return hit;
    }
    let size = vec2i(grid.size.xy);
    let top = 31 - countLeadingZeros(max(size.x, size.y) - 1) + 1;
    let facing = against(c);
    var passage = Passage(c.enter, 0.0, c.normal);
    var column = clamp(vec2i(floor(c.origin.xy + c.enter * c.slope.xy)), vec2i(0), size - 1);
    var level = FIRST_LEVEL;
    var first = column_level_first(level);
    // Columns of level 0 that a straight line passes, each once; for each it goes down and up at most once.
    let most = 4 * (size.x + size.y) + 64;
    for (var i = 0; i < most; i++) {
        let here = column >> vec2u(level);
        let low = here << vec2u(level);
        let high = low + (1 << level);
        let exits = (vec2f(select(low, high, c.forwards.xy)) - c.origin.xy) * c.inverse.xy;
        passage.leave = min(exits.x, exits.y);
        let number = u32(here.y) * column_count(level).x + u32(here.x);
        let part = part_of(c, first + number * column_words(), passage.enter, min(passage.leave, end));
        if (level == 0) {
            if (meets_in(ray, c, vec2u(column), part, passage, &hit)) {
                return hit;
            }
        } else if (any_passed(part)) {
            level -= 1;
            first -= column_level_words(level);
            continue;
        }
        let along = exits == vec2f(passage.leave);
        let beside = clamp(vec2i(floor(c.origin.xy + passage.leave * c.slope.xy)), low, high - 1);
        let next = select(beside, select(low - 1, high, c.forwards.xy), along);
        if (passage.leave >= end || any(next < vec2i(0)) || any(next >= size)) {
            return hit;
        }
        // Up where the coarser column is left.
        if (level < u32(top) && any((next >> vec2u(level + 1)) != (column >> vec2u(level + 1)))) {
            first += column_level_words(level);
            level += 1;
        }
        column = next;
        passage.enter = passage.leave;
        passage.normal = select(vec3f(0.0), facing, vec3<bool>(along, false));
    }
    return hit;
}

// Near where it begins a ray may be met at once: it begins with the finest columns.
const FIRST_LEVEL = 0u;
