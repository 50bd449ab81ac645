// The sides of a voxel's surfaces: for each axis k that towards +k and that towards −k, as far as they are shown. Each has a
// radiance of its own.

import package::common::attributes::VoxelSurface;
import package::common::sheet::{FRONT_HIGH, FRONT_LOW, TWO_SIDED, middle_of, sheet_normal, unpack_sheets};
import package::common::trace::Apex;

// Three of each voxel, axis after axis.
var<storage, read> sheets: array<vec2u>;

// Number 2k looks towards +k, number 2k + 1 towards −k.
const SIDES = 6u;

// Whether a side is the front of a sheet or, where surfaces have two sides, the back of the other sheet.
fn side_shown(covered: u32, index: u32) -> bool {
    let front = FRONT_HIGH << (index & 1);
    return (covered & front) != 0 || ((covered & TWO_SIDED) != 0 && (covered & (FRONT_HIGH | FRONT_LOW)) != 0);
}

fn has_sheets(slot: u32) -> bool {
    return (sheets[3 * slot].y | sheets[3 * slot + 1].y | sheets[3 * slot + 2].y) != 0;
}

// A side as light arrives at it: false where there is none. Too little of a surface for a sheet counts as the first side, along the
// mean normal.
fn side_apex(cell: vec3u, slot: u32, surface: VoxelSurface, index: u32, turn: f32, apex: ptr<function, Apex>) -> bool {
    let centre = vec3f(cell) + 0.5;
    let axis = index / 2;
    let words = sheets[3 * slot + axis];
    if (words.y == 0) {
        *apex = Apex(centre, surface.normal, turn);
        return index == 0 && !has_sheets(slot) && any(surface.normal != vec3f(0.0));
    }
    let pair = unpack_sheets(words);
    let up = normalize(sheet_normal(pair, axis));
    let low = (index & 1) == 1;
    let own = (words.y & (FRONT_HIGH << (index & 1))) != 0;
    let height = select(pair.high, pair.low, low == own);
    *apex = Apex(centre + middle_of(pair, height, axis), select(up, -up, low), turn);
    return side_shown(words.y, index);
}
