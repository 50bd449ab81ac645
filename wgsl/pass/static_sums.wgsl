// What triangles that never move add to each voxel, from where they were voxelized by themselves; nothing else yet.

import package::common::dispatch::dispatch_index;
import package::common::grid::{cell_bit, cell_word};
import package::common::voxels::level_cell;

var<storage, read_write> sums: array<u32>;
var<storage, read> static_occupancy: array<u32>;
var<storage, read> static_ranks: array<u32>;
var<storage, read> static_sums: array<u32>;

// Words of a voxel.
override STRIDE: u32 = 14;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let word = cell_word(cell, 0);
    let bit = 1u << cell_bit(cell);
    let occupied = (static_occupancy[word] & bit) != 0;
    let own = static_ranks[word] + countOneBits(static_occupancy[word] & (bit - 1));
    for (var i = 0u; i < STRIDE; i++) {
        var sum = 0u;
        if (occupied) {
            sum = static_sums[own * STRIDE + i];
        }
        sums[slot * STRIDE + i] = sum;
    }
}
