// Where each level's cells begin in the list, how many they are, and how many workgroups cover them.

import package::common::grid::{grid, level_first_word, LevelRun};
import package::common::dispatch::dispatch_groups;

var<storage, read> ranks: array<u32>;
var<storage, read_write> levels: array<LevelRun>;

@compute @workgroup_size(16)
fn main(@builtin(local_invocation_index) level: u32) {
    if (level >= grid.level_count) {
        return;
    }
    let first = ranks[level_first_word(level)];
    var end = ranks[arrayLength(&ranks) - 1];
    if (level + 1 < grid.level_count) {
        end = ranks[level_first_word(level + 1)];
    }
    levels[level] = LevelRun(dispatch_groups(end - first, 64), first, end - first);
}
