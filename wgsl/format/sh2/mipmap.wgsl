// SH mipmapping, `linear`: the mean of the children's coefficients, exact for both bands. Opacities composite as the
// six faces' do, so that a thin wall stays opaque. Level 1 makes coefficients of level 0: each voxel emits from
// the side of its normal, or to both sides without one.

import package::common::attributes::voxel_surface;
import package::common::coverage::composite_coverage;
import package::common::voxels::{is_occupied, voxel_slot};
import package::format::basis::{COEFFICIENTS, LOBE0, LOBE1, SixOpacities, decode_opacity, encode_opacity, mean_opacity};

@group(2) @binding(1) var base_source: texture_3d<f32>;
@group(2) @binding(2) var harmonics_source: texture_3d<f32>;
@group(2) @binding(9) var harmonics_target: texture_storage_3d<rgba16float, write>;

fn child_of_base(cell: vec3u) -> array<vec4f, 4> {
    var c = array<vec4f, 4>();
    let value = textureLoad(base_source, cell, 0);
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

fn child_of_harmonics(cell: vec3u) -> array<vec4f, 4> {
    let depth = textureDimensions(harmonics_source).z / COEFFICIENTS;
    var c: array<vec4f, 4>;
    for (var k = 0u; k < COEFFICIENTS; k++) {
        c[k] = textureLoad(harmonics_source, cell + vec3u(0, 0, k * depth), 0);
    }
    return c;
}

fn voxel_mipmap(cell: vec3u, level: u32) {
    var sum: array<vec3f, 4>;
    var weight = 0.0;
    var positive: array<vec3f, 8>;
    var negative: array<vec3f, 8>;
    for (var i = 0u; i < 8; i++) {
        let child = cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2);
        var c: array<vec4f, 4>;
        if (level == 1) {
            c = child_of_base(child);
        } else {
            c = child_of_harmonics(child);
        }
        for (var k = 0u; k < COEFFICIENTS; k++) {
            sum[k] += c[k].rgb;
        }
        let alpha = vec4f(c[0].a, c[1].a, c[2].a, c[3].a);
        weight += mean_opacity(alpha);
        let six = decode_opacity(alpha);
        positive[i] = six.positive;
        negative[i] = six.negative;
    }
    let alpha = encode_opacity(SixOpacities(composite_coverage(positive), composite_coverage(negative)));
    let scale = mean_opacity(alpha) / max(weight, 1e-6);
    let depth = textureDimensions(harmonics_target).z / COEFFICIENTS;
    for (var k = 0u; k < COEFFICIENTS; k++) {
        textureStore(harmonics_target, cell + vec3u(0, 0, k * depth), vec4f(sum[k] * scale, alpha[k]));
    }
}
