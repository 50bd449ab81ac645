// SH mipmapping, `linear`: the mean of the children's premultiplied coefficients, exact for both bands. Opacities
// along the axes composite as the six faces' do, so that a thin wall stays opaque. Level 1 makes coefficients
// of level 0: each voxel emits from the side of its normal, or all around without one.

import package::common::attributes::voxel_surface;
import package::common::coverage::composite_coverage;
import package::common::voxels::{is_occupied, voxel_slot};
import package::format::basis::{COEFFICIENTS, SH0, LOBE0, LOBE1};

@group(2) @binding(1) var base_source: texture_3d<f32>;
@group(2) @binding(2) var harmonics_source: texture_3d<f32>;
@group(2) @binding(9) var harmonics_target: texture_storage_3d<rgba16float, write>;

// Radiance coefficients; alpha as in `basis`.
fn child_of_base(cell: vec3u) -> array<vec4f, 4> {
    let value = textureLoad(base_source, cell, 0);
    var c = array(vec4f(value.rgb / SH0, value.a), vec4f(vec3f(0.0), value.a), vec4f(vec3f(0.0), value.a), vec4f(vec3f(0.0), value.a));
    if (value.a <= 0.0 || !is_occupied(cell, 0)) {
        return c;
    }
    let normal = voxel_surface(voxel_slot(cell)).normal;
    if (any(normal != vec3f(0.0))) {
        c[0] = vec4f(value.rgb * LOBE0, value.a);
        for (var axis = 0; axis < 3; axis++) {
            c[axis + 1] = vec4f(value.rgb * LOBE1 * normal[axis], value.a);
        }
    }
    return c;
}

fn child_of_harmonics(cell: vec3u) -> array<vec4f, 4> {
    let depth = textureDimensions(harmonics_source).z / COEFFICIENTS;
    var c: array<vec4f, 4>;
    for (var k = 0u; k < COEFFICIENTS; k++) {
        c[k] = textureLoad(harmonics_source, cell + vec3u(0, 0, k * depth), 0);
    }
    return c;
}

fn voxel_mipmap(cell: vec3u, level: u32) {
    var sum: array<vec4f, 4>;
    var opacity: array<vec3f, 8>;
    for (var i = 0u; i < 8; i++) {
        let child = cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2);
        var c: array<vec4f, 4>;
        if (level == 1) {
            c = child_of_base(child);
        } else {
            c = child_of_harmonics(child);
        }
        for (var k = 0u; k < COEFFICIENTS; k++) {
            sum[k] += c[k] / 8.0;
        }
        opacity[i] = vec3f(c[1].a, c[2].a, c[3].a);
    }
    let coverage = composite_coverage(opacity);
    let depth = textureDimensions(harmonics_target).z / COEFFICIENTS;
    let alpha = vec4f(sum[0].a, coverage);
    for (var k = 0u; k < COEFFICIENTS; k++) {
        textureStore(harmonics_target, cell + vec3u(0, 0, k * depth), vec4f(sum[k].rgb, alpha[k]));
    }
}
