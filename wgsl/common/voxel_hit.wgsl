// The first occupied cell of a level along a ray, and the face through which the ray enters it. Empty bricks are
// passed at a stride, cells by whole numbers (Amanatides and Woo, "A Fast Voxel Traversal Algorithm", 1987).

import package::common::grid::{cell_bit, cell_word, level_size};
import package::common::voxels::occupancy;

struct VoxelHit {
    cell: vec3u,
    // Along the axis of the face; the ray's own direction where it starts in the cell.
    face: vec3f,
    found: bool,
}

// Lengths are cells of the level; the direction is unit.
fn first_voxel(origin: vec3f, direction: vec3f, level: u32) -> VoxelHit {
    var hit: VoxelHit;
    hit.face = direction;
    let size = vec3i(level_size(level));
    // A finite slope for every axis: an axis-parallel ray never leaves sideways.
    let slope = select(direction, vec3f(1e-12), abs(direction) < vec3f(1e-12));
    let inverse = 1.0 / slope;
    let forwards = slope > vec3f(0.0);
    let to_low = -origin * inverse;
    let to_high = (vec3f(size) - origin) * inverse;
    let enters = min(to_low, to_high);
    let leaves = max(to_low, to_high);
    let enter = max(enters.x, max(enters.y, enters.z));
    if (max(enter, 0.0) > min(leaves.x, min(leaves.y, leaves.z))) {
        return hit;
    }
    if (enter > 0.0) {
        hit.face = select(vec3f(0.0), vec3f(1.0), enters == vec3f(enter));
    }
    let start = origin + max(enter, 0.0) * slope;
    var cell = clamp(vec3i(floor(start)), vec3i(0), size - 1);
    let most = u32(size.x + size.y + size.z);
    for (var i = 0u; i < most; i++) {
        let word = occupancy[cell_word(vec3u(cell), level)];
        if (((word >> cell_bit(vec3u(cell))) & 1) != 0) {
            hit.cell = vec3u(cell);
            hit.found = true;
            return hit;
        }
        let low = select(cell, cell & vec3i(-4, -4, -2), word == 0);
        let extent = select(vec3i(1), vec3i(4, 4, 2), word == 0);
        let exits = (vec3f(select(low, low + extent, forwards)) - start) * inverse;
        let t = min(exits.x, min(exits.y, exits.z));
        let along = exits == vec3f(t);
        let beside = clamp(vec3i(floor(start + t * slope)), low, low + extent - 1);
        cell = select(beside, select(low - 1, low + extent, forwards), along);
        if (any(cell < vec3i(0)) || any(cell >= size)) {
            return hit;
        }
        hit.face = select(vec3f(0.0), vec3f(1.0), along);
    }
    return hit;
}
