// The sides of a voxel's surfaces: of each of its planes the one towards +k and the one towards −k, as far as they are shown.
// Each has a radiance of its own.

import package::common::attributes::VoxelSurface;
import package::common::plane::{SHOWS_HIGH, SHOWS_LOW, middle_of, plane_normal, unpack_plane};
import package::common::trace::Apex;

// Three of each voxel, axis after axis.
var<storage, read> planes: array<vec2u>;

// Number 2k looks towards +k, number 2k + 1 towards −k.
const SIDES = 6u;

fn side_shown(covered: u32, index: u32) -> bool {
    return (covered & select(SHOWS_LOW, SHOWS_HIGH, (index & 1) == 0)) != 0;
}

fn has_planes(slot: u32) -> bool {
    return (planes[3 * slot].y | planes[3 * slot + 1].y | planes[3 * slot + 2].y) != 0;
}

// A side as light arrives at it: false where there is none. Too little of a surface for a plane counts as the first side, along the
// mean normal.
fn side_apex(cell: vec3u, slot: u32, surface: VoxelSurface, index: u32, turn: f32, apex: ptr<function, Apex>) -> bool {
    let centre = vec3f(cell) + 0.5;
    let axis = index / 2;
    let words = planes[3 * slot + axis];
    if (words.y == 0) {
        *apex = Apex(centre, surface.normal, turn);
        return index == 0 && !has_planes(slot) && any(surface.normal != vec3f(0.0));
    }
    let plane = unpack_plane(words);
    let up = normalize(plane_normal(plane, axis));
    *apex = Apex(centre + middle_of(plane, axis), select(-up, up, (index & 1) == 0), turn);
    return side_shown(words.y, index);
}
