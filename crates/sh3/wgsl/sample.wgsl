// The coefficients' sum in the direction that the observer is in. What is more than opaque counts as opaque.

import package::common::isotropic_base::sample_over_base;
import package::common::volume::sample_block;
import package::format::basis::{BANDS, harmonic};

var base: texture_3d<f32>;
var nine: texture_3d<f32>;

// `level` counts from the coefficients' first, which is level 1 of the grid.
fn sample_nine(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    var sum = vec4f(0.0);
    for (var k = 0u; k < BANDS; k++) {
        sum += harmonic(k, -direction) * sample_block(nine, k, BANDS, uvw, level);
    }
    let opacity = saturate(sum.a);
    return vec4f(max(sum.rgb, vec3f(0.0)) * (opacity / max(sum.a, 1e-6)), opacity);
}

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let coarse = sample_nine(uvw, max(level - 1.0, 0.0), direction);
    if (level >= 1.0) {
        return coarse;
    }
    return sample_over_base(base, uvw, level, coarse);
}
