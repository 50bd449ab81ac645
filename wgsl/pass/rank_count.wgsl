// Bits set in each word, to be summed by the scan; one word past the end holds zero.

import package::common::dispatch::dispatch_index;

@group(1) @binding(0) var<storage, read> occupancy: array<u32>;
@group(1) @binding(1) var<storage, read_write> ranks: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let word = dispatch_index(id, 64);
    if (word < arrayLength(&occupancy)) {
        ranks[word] = countOneBits(occupancy[word]);
    } else if (word == arrayLength(&occupancy)) {
        ranks[word] = 0;
    }
}
