// A voxel of level 0 as a cell: a surface covers, and shows its light, at its front.

import package::common::attributes::voxel_surface;
import package::common::voxels::{is_occupied, voxel_slot};
import package::format::cell::{Cell, emitter};

// With this premultiplied radiance and opacity.
fn voxel_cell(cell: vec3u, value: vec4f) -> Cell {
    if (value.a <= 0.0 || !is_occupied(cell, 0)) {
        return Cell();
    }
    let surface = voxel_surface(voxel_slot(cell));
    return emitter(value.rgb / value.a, value.a * surface.front, value.a * surface.back);
}
