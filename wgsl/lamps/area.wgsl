// Rays of a glossy lobe meet area lights themselves (see common/lamp.wgsl): a light's mirror image has its shape, not its voxels'.

import package::common::environment::environment;
import package::common::grid::{from_voxel, grid};
import package::common::lamp::rays_share;
import package::common::light::{Light, LIGHT_AREA, area_corners, lights};
import package::common::ray::RayHit;
import package::common::trace::Lobe;

const MEETS_LAMPS = true;

// Where a ray meets a light's polygon, along it; negative where it doesn't.
fn lamp_distance(light: Light, origin: vec3f, direction: vec3f) -> f32 {
    let towards = dot(direction, light.direction);
    if (towards == 0.0 || (towards > 0.0 && light.size == 0.0)) {
        return -1.0;
    }
    let distance = dot(light.position - origin, light.direction) / towards;
    let at = origin + distance * direction;
    let c = area_corners(light);
    var inside = true;
    for (var i = 0; i < 4; i++) {
        let edge = c[(i + 1) % 4] - c[i];
        inside = inside && dot(cross(edge, at - c[i]), light.direction) >= 0.0;
    }
    return select(-1.0, distance, inside);
}

// Radiance that a ray of a lobe brings from the area lights that it meets. What it hit among the voxels hides lights behind it, but a
// light is met in its own voxels.
fn lamps_along(lobe: Lobe, origin_voxel: vec3f, direction: vec3f, hit: RayHit) -> vec3f {
    let origin = from_voxel(origin_voxel);
    let met = select(1e30, hit.distance, hit.found);
    let blocker = origin + met * grid.voxel_size * direction;
    var sum = vec3f(0.0);
    for (var i = 0u; i < environment.light_count; i++) {
        let light = lights[i];
        if (light.kind == LIGHT_AREA) {
            let distance = lamp_distance(light, origin, direction);
            let own = abs(dot(blocker - light.position, light.direction)) < grid.voxel_size;
            if (distance > 0.0 && (own || distance < met * grid.voxel_size)) {
                sum += light.intensity * rays_share(light, lobe, origin);
            }
        }
    }
    return sum;
}
