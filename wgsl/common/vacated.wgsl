// Cells that were occupied when the volume was last stored and are not any more, as the bits of a word of their level.

import package::common::grid::{brick_count, level_first_word};
import package::common::voxels::occupancy;

var<storage, read> occupancy_before: array<u32>;

// `index` counts the level's words.
fn vacated_bits(index: u32, level: u32) -> u32 {
    let bricks = brick_count(level);
    if (index >= bricks.x * bricks.y * bricks.z) {
        return 0;
    }
    let word = level_first_word(level) + index;
    return occupancy_before[word] & ~occupancy[word];
}
