// Isotropic sampling: quadrilinear, direction ignored (RAU §5.2.1).

import package::common::volume::sample_volume;

var base: texture_3d<f32>;

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    return sample_volume(base, uvw, level);
}
