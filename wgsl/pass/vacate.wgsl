// Empties the cells of the volume's level 0 that something has left. One thread a word of the bitmask.

import package::common::dispatch::dispatch_index;
import package::common::grid::{bit_offset, brick_at};
import package::common::vacated::vacated_bits;
import package::format::store::voxel_store;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    for (var bits = vacated_bits(index, 0); bits != 0; bits &= bits - 1) {
        let cell = brick_at(index, 0) * vec3u(4, 4, 2) + bit_offset(firstTrailingBit(bits));
        voxel_store(cell, vec3f(0.0), vec3f(0.0), 0.0);
    }
}
