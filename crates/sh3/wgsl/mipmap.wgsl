// Coefficients add up, scaled so that opacity averaged over six sides is what the sides' children composite to.

import package::common::attributes::voxel_surface;
import package::common::coverage::composite_coverage;
import package::common::volume::{block_texel, load_volume};
import package::common::voxels::{is_occupied, voxel_slot};
import package::encoding::{SignedVolumeTarget, encode_texel};
import package::format::basis::{BANDS, Y0, Y1, Y20, Y22, area_coefficient};

var base_source: texture_3d<f32>;
var nine_source: texture_3d<f32>;
var nine_target: SignedVolumeTarget;

fn child_coefficient(k: u32, cell: vec3u, level: u32) -> vec4f {
    if (level > 1) {
        return load_volume(nine_source, block_texel(cell, k, BANDS, textureDimensions(nine_source).z));
    }
    let value = load_volume(base_source, cell);
    if (value.a <= 0.0 || !is_occupied(cell, 0)) {
        return vec4f(0.0);
    }
    let surface = voxel_surface(voxel_slot(cell));
    return value * area_coefficient(k, surface.normal, surface.front, surface.back);
}

fn voxel_mipmap(cell: vec3u, level: u32) {
    var positive: array<vec3f, 8>;
    var negative: array<vec3f, 8>;
    var before = 0.0;
    for (var i = 0u; i < 8; i++) {
        let child = cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2);
        // Along an axis the functions xy, yz and xz are zero.
        let c0 = Y0 * child_coefficient(0, child, level).a;
        let odd = Y1 * vec3f(child_coefficient(1, child, level).a, child_coefficient(2, child, level).a, child_coefficient(3, child, level).a);
        let c20 = Y20 * child_coefficient(7, child, level).a;
        let c22 = Y22 * child_coefficient(8, child, level).a;
        let even = c0 + vec3f(c22 - c20, -c22 - c20, 2.0 * c20);
        positive[i] = saturate(even + odd);
        negative[i] = saturate(even - odd);
        before += dot(positive[i] + negative[i], vec3f(1.0));
    }
    let after = dot(composite_coverage(positive) + composite_coverage(negative), vec3f(1.0));
    let scale = after / max(before, 1e-6);
    let depth = textureDimensions(nine_target).z;
    for (var k = 0u; k < BANDS; k++) {
        var sum = vec4f(0.0);
        for (var i = 0u; i < 8; i++) {
            sum += child_coefficient(k, cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2), level);
        }
        textureStore(nine_target, block_texel(cell, k, BANDS, depth), encode_texel(sum * scale));
    }
}
