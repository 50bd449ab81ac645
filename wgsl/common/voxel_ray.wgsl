// A ray through the occupancy bitmask, empty bricks at a stride (DVS §2.2's occlusion by ray, on VGI's bitmask).

import package::common::grid::{grid, cell_word, cell_bit};
import package::common::voxels::occupancy;

// Whether any occupied cell lies on origin + t·direction with 0 <= t < reach; voxel units.
fn ray_blocked(origin: vec3f, direction: vec3f, reach: f32) -> bool {
    // A finite slope for every axis: an axis-parallel ray never leaves sideways.
    let slope = select(direction, vec3f(1e-12), abs(direction) < vec3f(1e-12));
    let inverse = 1.0 / slope;
    let forwards = slope > vec3f(0.0);
    let size = vec3f(grid.size);
    var t = 0.0;
    // Each step leaves a cell or a brick; a straight line meets at most the sum of the grid's sides.
    let most = grid.size.x + grid.size.y + grid.size.z;
    for (var i = 0u; i < most; i++) {
        let p = origin + t * slope;
        if (t >= reach || any(p < vec3f(0.0)) || any(p >= size)) {
            return false;
        }
        let cell = vec3u(p);
        let word = occupancy[cell_word(cell, 0)];
        var low = vec3f(cell);
        var extent = vec3f(1.0);
        if (word == 0) {
            low = vec3f(cell & vec3u(0xfffffffcu, 0xfffffffcu, 0xfffffffeu));
            extent = vec3f(4.0, 4.0, 2.0);
        } else if (((word >> cell_bit(cell)) & 1) != 0) {
            return true;
        }
        let exits = (select(low, low + extent, forwards) - origin) * inverse;
        t = max(min(exits.x, min(exits.y, exits.z)), t) + 1e-3;
    }
    return false;
}
