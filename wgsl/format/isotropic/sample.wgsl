// Isotropic sampling: quadrilinear, direction ignored (RAU §5.2.1).

import package::common::seen_ahead::{SeenAhead, all_ahead};
import package::common::volume::sample_volume;

// Whether opacity from level 1 up is that of a surface's front only, so that a cone may reach back to the surface
// that it leaves.
const VOXEL_ONE_SIDED = false;

var base: texture_3d<f32>;

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    return sample_volume(base, uvw, level);
}

fn voxel_sample_ahead(uvw: vec3f, level: f32, direction: vec3f, apex: vec3f, behind: vec3f) -> SeenAhead {
    return all_ahead(voxel_sample(uvw, level, direction));
}
