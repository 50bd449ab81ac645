// A voxel of level 0 as a cell: a surface covers, and shows its light, at its front.

import package::common::attributes::voxel_surface;
import package::common::voxels::{is_occupied, voxel_slot};
import package::format::cell::{Cell, encode_cell};

// With this premultiplied radiance and opacity.
fn voxel_cell(cell: vec3u, value: vec4f) -> Cell {
    if (value.a <= 0.0 || !is_occupied(cell, 0)) {
        return Cell();
    }
    let surface = voxel_surface(voxel_slot(cell));
    let front = surface.front;
    let back = surface.back;
    return encode_cell(
        mat3x4f(value * front.x, value * front.y, value * front.z),
        mat3x4f(value * back.x, value * back.y, value * back.z),
    );
}
