// The bitmask's layout: a word holds a brick of 4 x 4 x 2 cells, bricks run x, y, z within a level,
// levels follow each other, the finest first.

import package::common::frame::frame;

// One level's run in the list of cells, and the workgroups of 64 that cover it.
struct LevelRun {
    groups: vec3u,
    first: u32,
    count: u32,
}

fn level_size(level: u32) -> vec3u {
    return frame.grid_size >> vec3u(level);
}

fn brick_count(level: u32) -> vec3u {
    return (level_size(level) + vec3u(3, 3, 1)) / vec3u(4, 4, 2);
}

// The brick of a level's word number `index`.
fn brick_at(index: u32, level: u32) -> vec3u {
    let bricks = brick_count(level);
    return vec3u(index % bricks.x, index / bricks.x % bricks.y, index / (bricks.x * bricks.y));
}

fn level_first_word(level: u32) -> u32 {
    return frame.level_words[level / 4][level % 4];
}

// Cells along a brick's sides as powers of two, and how far apart their bits are.
const BRICK_SHIFT = vec3u(2, 2, 1);
const BRICK_BITS = vec3u(1, 4, 16);

// Words from a brick to the next along each axis.
fn brick_strides(level: u32) -> vec3u {
    let bricks = brick_count(level);
    return vec3u(1, bricks.x, bricks.x * bricks.y);
}

fn cell_word(cell: vec3u, level: u32) -> u32 {
    return level_first_word(level) + dot(cell >> BRICK_SHIFT, brick_strides(level));
}

fn cell_bit(cell: vec3u) -> u32 {
    return dot(cell & vec3u(3, 3, 1), BRICK_BITS);
}

fn bit_offset(bit: u32) -> vec3u {
    return vec3u(bit & 3, (bit >> 2) & 3, bit >> 4);
}

fn pack_cell(cell: vec3u) -> u32 {
    return cell.x | (cell.y << 10) | (cell.z << 20);
}

fn unpack_cell(packed_cell: u32) -> vec3u {
    return vec3u(packed_cell & 1023, (packed_cell >> 10) & 1023, packed_cell >> 20);
}
