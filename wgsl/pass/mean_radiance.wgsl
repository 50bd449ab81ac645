// One radiance for each voxel from those of its sides, as storage formats take it.

import package::common::dispatch::dispatch_index;
import package::common::sheet::{ALL_SQUARES, HAS_BACK, MORE, sheet_normal, unpack_sheet, SHEETS, SIDES};
import package::common::radiance::unpack_radiance;
import package::common::side::{sheet_entry, side_number};
import package::common::voxels::level_cell;

var<storage, read> side_radiance: array<u32>;
var<storage, read_write> slot_radiance: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    var sum = vec4f(0.0);
    for (var i = 0u; i < SHEETS; i++) {
        let words = sheet_entry(slot, i);
        if (words.y == 0) {
            sum = vec4f(unpack_radiance(side_radiance[SIDES * slot]), 1.0);
            break;
        }
        let area = f32(max(countOneBits(words.y & ALL_SQUARES), 1u)) * length(sheet_normal(unpack_sheet(words)));
        var sent = unpack_radiance(side_radiance[SIDES * slot + side_number(words.y, false)]);
        if ((words.y & HAS_BACK) != 0) {
            // One value stands for both sides: what either sends.
            sent += unpack_radiance(side_radiance[SIDES * slot + side_number(words.y, true)]);
        }
        sum += area * vec4f(sent, 1.0);
        if ((words.y & MORE) == 0) {
            break;
        }
    }
    slot_radiance[slot] = vec4f(sum.rgb / sum.a, 1.0);
}
