// Rays of a glossy lobe see what voxels emit. Other gathers get it from the polygons themselves (see emitters/sampled.wgsl).

import package::common::attributes::voxel_surface;
import package::common::ray::RayHit;
import package::common::sheet::SIDES;
import package::common::trace::Lobe;

const MEETS_LAMPS = true;

fn lamps_along(lobe: Lobe, origin_voxel: vec3f, direction: vec3f, hit: RayHit) -> vec3f {
    if (hit.found && hit.shown) {
        return voxel_surface(hit.side / SIDES).emission;
    }
    return vec3f(0.0);
}
