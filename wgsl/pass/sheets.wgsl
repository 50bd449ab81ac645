// Each voxel's sheets from what its triangles added up, packed (see common/sheet.wgsl).

import package::common::dispatch::dispatch_index;
import package::common::sheet::{AXIS_STRIDE, HAS_BACK, LOW, MORE, SHEETS, SHEET_ENTRIES, SHEET_STRIDE, Sheet, THERE, TWO_SIDED, pack_sheet, pack_side_reflectance};
import package::common::voxels::level_cell;

// As common/sheet_sums.wgsl adds them up.
var<storage, read> sheet_sums: array<u32>;
// As many of each voxel as it may have: see common/side.wgsl.
var<storage, read_write> sheets: array<vec2u>;


fn sum_at(index: u32) -> f32 {
    return f32(sheet_sums[index]);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    for (var i = SHEETS; i < SHEET_ENTRIES; i++) {
        sheets[SHEET_ENTRIES * slot + i] = vec2u(0);
    }
    var count = 0u;
    for (var i = 0u; i < SHEETS; i++) {
        let first = slot * SHEET_STRIDE + AXIS_STRIDE * (i / 2);
        let low = i & 1;
        let weight = sum_at(first + low);
        if (weight == 0.0) {
            continue;
        }
        let other = sum_at(first + 1 - low);
        let height = 3.0 * sum_at(first + 2 + low) / weight - 1.5;
        let slope = 2.0 * vec2f(sum_at(first + 4), sum_at(first + 5)) / (weight + other) - 1.0;
        var bits = sheet_sums[first + 6] | THERE | select(0u, LOW, low == 1);
        if ((bits & TWO_SIDED) != 0 && other == 0.0) {
            bits |= HAS_BACK;
        }
        let reflects = 7 + 3 * low;
        let reflected = vec3f(sum_at(first + reflects), sum_at(first + reflects + 1), sum_at(first + reflects + 2));
        let reflectance = pack_side_reflectance(reflected / weight);
        let side = SHEET_ENTRIES * slot + SHEETS + i / 2;
        sheets[side][low] = reflectance;
        if ((bits & HAS_BACK) != 0) {
            sheets[side][1 - low] = reflectance;
        }
        if (count > 0) {
            sheets[SHEET_ENTRIES * slot + count - 1].y |= MORE;
        }
        sheets[SHEET_ENTRIES * slot + count] = pack_sheet(Sheet(height, slope, i / 2, bits));
        count++;
    }
    for (; count < SHEETS; count++) {
        sheets[SHEET_ENTRIES * slot + count] = vec2u(0);
    }
}
