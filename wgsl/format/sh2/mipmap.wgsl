// SH mipmapping, `linear`: the mean of the children's premultiplied coefficients, exact for both bands. Level 1
// makes coefficients of level 0: each voxel emits from the side of its normal, or all around without one.

import package::common::attributes::voxel_surface;
import package::common::voxels::{is_occupied, voxel_slot};
import package::format::basis::{COEFFICIENTS, SH0, LOBE0, LOBE1};

@group(2) @binding(1) var base_source: texture_3d<f32>;
@group(2) @binding(2) var harmonics_source: texture_3d<f32>;
@group(2) @binding(9) var harmonics_target: texture_storage_3d<rgba16float, write>;

fn children_of_base(cell: vec3u) -> array<vec4f, 4> {
    var sum = array<vec4f, 4>();
    for (var i = 0u; i < 8; i++) {
        let child = cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2);
        let value = textureLoad(base_source, child, 0);
        if (value.a <= 0.0 || !is_occupied(child, 0)) {
            continue;
        }
        let normal = voxel_surface(voxel_slot(child)).normal;
        if (all(normal == vec3f(0.0))) {
            sum[0] += vec4f(value.rgb / SH0, value.a);
        } else {
            sum[0] += vec4f(value.rgb * LOBE0, value.a);
            sum[1] += vec4f(value.rgb * LOBE1 * normal.x, 0.0);
            sum[2] += vec4f(value.rgb * LOBE1 * normal.y, 0.0);
            sum[3] += vec4f(value.rgb * LOBE1 * normal.z, 0.0);
        }
    }
    return sum;
}

fn voxel_mipmap(cell: vec3u, level: u32) {
    let depth = textureDimensions(harmonics_target).z / COEFFICIENTS;
    if (level == 1) {
        let sum = children_of_base(cell);
        for (var k = 0u; k < COEFFICIENTS; k++) {
            textureStore(harmonics_target, cell + vec3u(0, 0, k * depth), sum[k] / 8.0);
        }
        return;
    }
    let depth_below = textureDimensions(harmonics_source).z / COEFFICIENTS;
    for (var k = 0u; k < COEFFICIENTS; k++) {
        var sum = vec4f(0.0);
        for (var i = 0u; i < 8; i++) {
            let child = cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2);
            sum += textureLoad(harmonics_source, child + vec3u(0, 0, k * depth_below), 0);
        }
        textureStore(harmonics_target, cell + vec3u(0, 0, k * depth), sum / 8.0);
    }
}
