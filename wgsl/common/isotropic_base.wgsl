// A level 0 that is the same from all sides, over levels that are not. Level 1 says from which side it is seen at
// all: where that is a quarter or more, level 0 counts in full.

import package::common::volume::sample_volume;

const FACING_FULL = 0.25;

// Between level 0 and `coarse`, which is level 1, for `level` in [0, 1).
fn sample_over_base(base: texture_3d<f32>, uvw: vec3f, level: f32, coarse: vec4f) -> vec4f {
    let fine = sample_volume(base, uvw, 0.0) * saturate(coarse.a / FACING_FULL);
    return mix(fine, coarse, max(level, 0.0));
}
