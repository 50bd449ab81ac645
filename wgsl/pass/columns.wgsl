// Columns of bits of a level: of the bitmask, or from the level below (VGI §4.1). One thread a word.

import package::common::columns::{column_count, column_level_first, column_level_words, column_words};
import package::common::dispatch::dispatch_index;
import package::common::grid::{cell_bit, cell_word, grid};
import package::common::step::step_params;

var<storage, read_write> occupancy: array<u32>;

// 32 cells along z.
fn of_cells(column: vec2u, word: u32) -> u32 {
    var bits = 0u;
    for (var i = 0u; i < 32 && 32 * word + i < grid.size.z; i++) {
        let cell = vec3u(column, 32 * word + i);
        bits |= ((occupancy[cell_word(cell, 0)] >> cell_bit(cell)) & 1) << i;
    }
    return bits;
}

fn of_children(column: vec2u, word: u32, level: u32) -> u32 {
    let count = column_count(level - 1);
    let first = column_level_first(level - 1) + word;
    var bits = 0u;
    for (var i = 0u; i < 4; i++) {
        let child = 2 * column + vec2u(i & 1, i >> 1);
        if (all(child < count)) {
            bits |= occupancy[first + (child.y * count.x + child.x) * column_words()];
        }
    }
    return bits;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let level = step_params.level;
    if (index >= column_level_words(level)) {
        return;
    }
    let word = index % column_words();
    let number = index / column_words();
    let width = column_count(level).x;
    let column = vec2u(number % width, number / width);
    var bits: u32;
    if (level == 0) {
        bits = of_cells(column, word);
    } else {
        bits = of_children(column, word, level);
    }
    occupancy[column_level_first(level) + index] = bits;
}
