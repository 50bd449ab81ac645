// The list of occupied cells, all levels, each at its rank (RAU §4.1.4 and §5.4): no cell twice, no counter.

import package::common::grid::{grid, brick_at, level_first_word, bit_offset, pack_cell};
import package::common::dispatch::dispatch_index;

var<storage, read> occupancy: array<u32>;
var<storage, read> ranks: array<u32>;
var<storage, read_write> cells: array<u32>;

fn list_word(word: u32) {
    var level = 0u;
    while (level + 1 < grid.level_count && level_first_word(level + 1) <= word) {
        level++;
    }
    let brick = brick_at(word - level_first_word(level), level);
    var rank = ranks[word];
    for (var bits = occupancy[word]; bits != 0; bits &= bits - 1) {
        cells[rank] = pack_cell(brick * vec3u(4, 4, 2) + bit_offset(firstTrailingBit(bits)));
        rank++;
    }
}

// Words that a thread looks at, most of which are empty: as many apart as a workgroup has threads.
override WORDS: u32 = 16;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let first = index / 64 * (64 * WORDS) + index % 64;
    for (var word = first; word < min(first + 64 * WORDS, arrayLength(&ranks) - 1); word += 64) {
        list_word(word);
    }
}
