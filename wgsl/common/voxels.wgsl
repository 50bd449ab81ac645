// The voxel substrate as passes read it. `occupancy` has one bit a cell for every level; `ranks` holds
// the number of set bits before each word, so rank = ranks[word] + bits below = the cell's place in
// `cells`. Level 0 comes first: there the rank is the voxel's attribute slot (RAU §5.4, VGI §4.1).

import package::common::grid::{cell_word, cell_bit, unpack_cell, LevelRun};

var<storage, read> occupancy: array<u32>;
var<storage, read> ranks: array<u32>;
var<storage, read> cells: array<u32>;
var<storage, read> levels: array<LevelRun>;

fn is_occupied(cell: vec3u, level: u32) -> bool {
    return ((occupancy[cell_word(cell, level)] >> cell_bit(cell)) & 1) != 0;
}

// The cell's place in `cells`. Only meaningful where it is occupied.
fn cell_rank(cell: vec3u, level: u32) -> u32 {
    let word = cell_word(cell, level);
    return ranks[word] + countOneBits(occupancy[word] & ((1u << cell_bit(cell)) - 1));
}

// The same where the cell's word of the bitmask is at hand, and its index.
fn rank_in(index: u32, word: u32, cell: vec3u) -> u32 {
    return ranks[index] + countOneBits(word & ((1u << cell_bit(cell)) - 1));
}

fn voxel_slot(cell: vec3u) -> u32 {
    return cell_rank(cell, 0);
}

// The cell that invocation `index` of a pass over a level works on; false past the level's end.
fn level_cell(index: u32, level: u32, cell: ptr<function, vec3u>) -> bool {
    if (index >= levels[level].count) {
        return false;
    }
    *cell = unpack_cell(cells[levels[level].first + index]);
    return true;
}
