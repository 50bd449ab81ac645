// Rays meet no lights, only surfaces: what voxels gather holds no area light, and where there is none there is nothing to meet.

import package::common::ray::RayHit;
import package::common::trace::Lobe;

const MEETS_LAMPS = false;

fn lamps_along(lobe: Lobe, origin_voxel: vec3f, direction: vec3f, hit: RayHit) -> vec3f {
    return vec3f(0.0);
}
