// Each voxel's sheets from what its triangles added up, packed (see common/sheet.wgsl).

import package::common::dispatch::dispatch_index;
import package::common::sheet::{Sheets, pack_sheets};
import package::common::voxels::level_cell;

// For each axis: weights of fronts towards + and −, their heights, two slopes, and the bits.
var<storage, read> sheet_sums: array<u32>;
// For each axis.
var<storage, read_write> sheets: array<vec2u>;

const SHEET_STRIDE = 21u;

fn sum_at(index: u32) -> f32 {
    return f32(sheet_sums[index]);
}

fn mean_sheets(first: u32) -> vec2u {
    let weight = vec2f(sum_at(first), sum_at(first + 1));
    let all = weight.x + weight.y;
    if (all == 0.0) {
        return vec2u(0);
    }
    let height = 3.0 * vec2f(sum_at(first + 2), sum_at(first + 3)) / max(weight, vec2f(1.0)) - 1.5;
    let slope = 2.0 * vec2f(sum_at(first + 4), sum_at(first + 5)) / all - 1.0;
    return pack_sheets(Sheets(height.x, height.y, slope, sheet_sums[first + 6]));
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    for (var axis = 0u; axis < 3; axis++) {
        sheets[3 * slot + axis] = mean_sheets(slot * SHEET_STRIDE + 7 * axis);
    }
}
