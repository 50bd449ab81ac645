// A voxel as coefficients: it emits from the side of its normal, or to both sides without one.

import package::common::attributes::voxel_surface;
import package::common::voxels::{is_occupied, voxel_slot};
import package::format::basis::{LOBE0, LOBE1, SixOpacities, encode_opacity, mean_opacity};

// Of a voxel of level 0 with this premultiplied radiance and opacity.
fn voxel_lobe(cell: vec3u, value: vec4f) -> array<vec4f, 4> {
    var c = array<vec4f, 4>();
    if (value.a <= 0.0 || !is_occupied(cell, 0)) {
        return c;
    }
    let surface = voxel_surface(voxel_slot(cell));
    let alpha = encode_opacity(SixOpacities(surface.front, surface.back));
    let radiance = value.rgb * mean_opacity(alpha);
    c[0] = vec4f(radiance * LOBE0, alpha.x);
    for (var axis = 0; axis < 3; axis++) {
        c[axis + 1] = vec4f(radiance * LOBE1 * surface.normal[axis], alpha[axis + 1]);
    }
    return c;
}
