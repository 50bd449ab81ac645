// How far away each block of 4 × 4 × 4 cells has the next one that holds an occupied cell, in blocks, by the largest of the three
// coordinates' differences: 0 where it holds one itself. Bytes, four along x in a word, after the bitmask in `occupancy`.

import package::common::grid::grid;

// Cells along a block's side as a power of two.
const BLOCK_SHIFT = 2u;
// No farther is looked.
const MOST_LEAP = 7u;

fn block_counts() -> vec3u {
    return (grid.size + 3) >> vec3u(BLOCK_SHIFT);
}

fn leap_rows() -> vec3u {
    let blocks = block_counts();
    return vec3u((blocks.x + 3) / 4, blocks.yz);
}

// Where the words of a pass' result begin: number 0 is the last one's.
fn leap_first(part: u32) -> u32 {
    let rows = leap_rows();
    return grid.bitmask_words + part * rows.x * rows.y * rows.z;
}

fn leap_word(block: vec3u) -> u32 {
    let rows = leap_rows();
    return grid.bitmask_words + (block.z * rows.y + block.y) * rows.x + block.x / 4;
}

fn leap_at(block: vec3u, word: u32) -> i32 {
    return i32((word >> (8 * (block.x & 3))) & 255);
}
