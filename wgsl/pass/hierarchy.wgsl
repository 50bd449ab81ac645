// One level of the bitmask from the level below: a parent is occupied where any of its children is
// (VGI §4.1). One thread a word.

import package::common::grid::{brick_at, brick_count, level_first_word};
import package::common::step::step_params;

var<storage, read_write> occupancy: array<u32>;

// The 2 x 2 x 1 parents of a brick's 4 x 4 x 2 children, as the low bits of rows 0 and 1.
fn parents(word: u32) -> u32 {
    let flat = (word | (word >> 16)) & 0xffff;
    let pairs_x = (flat | (flat >> 1)) & 0x5555;
    let pairs = pairs_x | (pairs_x >> 4);
    return (pairs & 1) | ((pairs >> 1) & 2) | (((pairs >> 8) & 1) << 4) | (((pairs >> 10) & 1) << 5);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let bricks = brick_count(step_params.level);
    if (id.x >= bricks.x * bricks.y * bricks.z) {
        return;
    }
    let brick = brick_at(id.x, step_params.level);
    let below = brick_count(step_params.level - 1);
    let first = level_first_word(step_params.level - 1);
    var word = 0u;
    for (var i = 0u; i < 8; i++) {
        let offset = vec3u(i & 1, (i >> 1) & 1, i >> 2);
        let child = brick * 2 + offset;
        if (all(child < below)) {
            let bits = parents(occupancy[first + (child.z * below.y + child.y) * below.x + child.x]);
            word |= bits << (offset.z * 16 + offset.y * 8 + offset.x * 2);
        }
    }
    occupancy[level_first_word(step_params.level) + id.x] = word;
}
