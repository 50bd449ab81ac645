// Empties the parents of what is left empty: the cells of a level in which nothing is occupied any more.

import package::common::dispatch::dispatch_index;
import package::common::grid::{bit_offset, brick_at};
import package::common::step::step_params;
import package::common::vacated::vacated_bits;
import package::format::mipmap::voxel_mipmap;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let level = step_params.level;
    for (var bits = vacated_bits(index, level); bits != 0; bits &= bits - 1) {
        voxel_mipmap(brick_at(index, level) * vec3u(4, 4, 2) + bit_offset(firstTrailingBit(bits)), level);
    }
}
