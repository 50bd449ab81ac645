// The list of occupied cells, all levels, each at its rank (RAU §4.1.4 and §5.4): no cell twice, no counter.

import package::common::frame::frame;
import package::common::grid::{brick_at, level_first_word, bit_offset, pack_cell};
import package::common::dispatch::dispatch_index;

@group(1) @binding(0) var<storage, read> occupancy: array<u32>;
@group(1) @binding(1) var<storage, read> ranks: array<u32>;
@group(1) @binding(2) var<storage, read_write> cells: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let word = dispatch_index(id, 64);
    if (word >= arrayLength(&occupancy)) {
        return;
    }
    var bits = occupancy[word];
    if (bits == 0) {
        return;
    }
    var level = 0u;
    while (level + 1 < frame.level_count && level_first_word(level + 1) <= word) {
        level++;
    }
    let brick = brick_at(word - level_first_word(level), level);
    var rank = ranks[word];
    while (bits != 0) {
        let bit = firstTrailingBit(bits);
        cells[rank] = pack_cell(brick * vec3u(4, 4, 2) + bit_offset(bit));
        rank++;
        bits &= bits - 1;
    }
}
