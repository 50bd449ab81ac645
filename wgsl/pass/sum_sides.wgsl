// What every side of a voxel sends in all: its own light, and what it reflects of gathered light beside it.

import package::common::dispatch::dispatch_index;
import package::common::radiance::{pack_radiance, unpack_radiance};
import package::common::sheet::SIDES;
import package::common::voxels::level_cell;

var<storage, read> direct: array<u32>;
var<storage, read> gathered: array<u32>;
var<storage, read_write> side_radiance: array<u32>;
override HAS_GATHERED: bool = false;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    for (var i = 0u; i < SIDES; i++) {
        let index = SIDES * slot + i;
        // Sides that aren't shown hold what nobody reads.
        var sent = direct[index];
        if (HAS_GATHERED) {
            sent = pack_radiance(unpack_radiance(sent) + unpack_radiance(gathered[index]));
        }
        side_radiance[index] = sent;
    }
}
