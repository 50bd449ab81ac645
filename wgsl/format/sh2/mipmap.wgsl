// SH mipmapping. `linear`: the mean of the children's coefficients, exact for both bands; `projected`: the mean of
// what they send through the parent's faces. Opacities composite as the six faces' do, so that a thin wall stays opaque.
// Level 1 makes coefficients of an isotropic level 0.

import package::common::coverage::composite_coverage;
import package::common::volume::{block_texel, load_volume};
import package::encoding::{SignedVolumeTarget, encode_texel};
import package::format::basis::{COEFFICIENTS, SixOpacities, decode_opacity, encode_opacity, mean_opacity};
import package::format::lobe::voxel_lobe;
import package::format::options::{BASE, BASE_ISOTROPIC, MIP, MIP_PROJECTED};
import package::format::project::project_child;

@group(2) @binding(1) var base_source: texture_3d<f32>;
@group(2) @binding(2) var harmonics_source: texture_3d<f32>;
@group(2) @binding(9) var harmonics_target: SignedVolumeTarget;

fn child_of_harmonics(cell: vec3u) -> array<vec4f, 4> {
    let depth = textureDimensions(harmonics_source).z;
    var c: array<vec4f, 4>;
    for (var k = 0u; k < COEFFICIENTS; k++) {
        c[k] = load_volume(harmonics_source, block_texel(cell, k, COEFFICIENTS, depth));
    }
    return c;
}

fn voxel_mipmap(cell: vec3u, level: u32) {
    var sum: array<vec3f, 4>;
    var weight = 0.0;
    var positive: array<vec3f, 8>;
    var negative: array<vec3f, 8>;
    for (var i = 0u; i < 8; i++) {
        let offset = vec3u(i & 1, (i >> 1) & 1, i >> 2);
        let child = cell * 2 + offset;
        var c: array<vec4f, 4>;
        if (level == 1 && BASE == BASE_ISOTROPIC) {
            c = voxel_lobe(child, load_volume(base_source, child));
        } else {
            c = child_of_harmonics(child);
        }
        var sent = array(c[0].rgb, c[1].rgb, c[2].rgb, c[3].rgb);
        if (MIP == MIP_PROJECTED) {
            sent = project_child(c, 1.0 - 2.0 * vec3f(offset));
        }
        for (var k = 0u; k < COEFFICIENTS; k++) {
            sum[k] += sent[k];
        }
        let alpha = vec4f(c[0].a, c[1].a, c[2].a, c[3].a);
        weight += mean_opacity(alpha);
        let six = decode_opacity(alpha);
        positive[i] = six.positive;
        negative[i] = six.negative;
    }
    let alpha = encode_opacity(SixOpacities(composite_coverage(positive), composite_coverage(negative)));
    let scale = mean_opacity(alpha) / max(weight, 1e-6);
    let depth = textureDimensions(harmonics_target).z;
    for (var k = 0u; k < COEFFICIENTS; k++) {
        textureStore(harmonics_target, block_texel(cell, k, COEFFICIENTS, depth), encode_texel(vec4f(sum[k] * scale, alpha[k])));
    }
}
