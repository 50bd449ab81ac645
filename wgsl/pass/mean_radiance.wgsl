// One radiance for each voxel from those of its sides, as storage formats take it.

import package::common::dispatch::dispatch_index;
import package::common::sheet::{ALL_SQUARES, FRONT_HIGH, FRONT_LOW, sheet_normal, unpack_sheets};
import package::common::radiance::unpack_radiance;
import package::common::side::{SIDES, has_sheets, sheets, side_shown};
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
    for (var i = 0u; i < SIDES; i++) {
        let words = sheets[3 * slot + i / 2];
        if (side_shown(words.y, i)) {
            // A surface of two sides sends what either does, by its area; two surfaces send their mean.
            let fronts = countOneBits(words.y & (FRONT_HIGH | FRONT_LOW));
            let sides = select(1u, 2u, side_shown(words.y, i ^ 1));
            let area = f32(countOneBits(words.y & ALL_SQUARES)) * length(sheet_normal(unpack_sheets(words), i / 2));
            sum += area * vec4f(unpack_radiance(side_radiance[SIDES * slot + i]), f32(fronts) / f32(sides));
        }
    }
    if (!has_sheets(slot)) {
        sum = vec4f(unpack_radiance(side_radiance[SIDES * slot]), 1.0);
    }
    slot_radiance[slot] = vec4f(sum.rgb / max(sum.a, 1e-6), 1.0);
}
