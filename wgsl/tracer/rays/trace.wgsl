// Rays through the occupancy bitmask (VGI §4.2): a lobe is the mean over rays in it, each to the first surface that it meets,
// whose own side says what it sends.

import package::common::environment::environment;
import package::common::radiance::unpack_radiance;
import package::common::ray::{Ray, RayHit, Tangent, arrive, leave};
import package::common::trace::{Apex, Gathered, LOBE_GGX, Lobe, Reach, vector_of};
import package::lamps::{MEETS_LAMPS, lamps_along};
import package::tracer::lobe::{lobe_direction, trace_params};
import package::walk::first_hit;

// What every side of a voxel sends: see common/side.wgsl.
var<storage, read> side_radiance: array<u32>;

// What a ray of a trace meets. What lies below the surface is looked for above it, as in a mirror.
fn shoot(apex: Apex, lobe: Lobe, reach: Reach, origin: Tangent, index: u32, direction: ptr<function, vec3f>) -> RayHit {
    let wanted = lobe_direction(lobe, index, apex.share);
    let below = min(dot(wanted, apex.normal), 0.0);
    *direction = wanted - 2.0 * below * apex.normal;
    let goal = Tangent(reach.point, reach.normal);
    var distance = reach.distance;
    if (any(goal.normal != vec3f(0.0))) {
        distance = arrive(*direction, origin.point, goal);
    }
    return first_hit(Ray(origin.point, *direction, distance, origin, goal));
}

fn trace_gather(apex: Apex, lobe: Lobe, reach: Reach) -> Gathered {
    let origin = leave(apex);
    var sum = vec4f(0.0);
    var vector = vec3f(0.0);
    var distance = reach.distance;
    for (var i = 0u; i < trace_params.rays; i++) {
        var direction: vec3f;
        let hit = shoot(apex, lobe, reach, origin, i, &direction);
        var arriving = vec4f(environment.sky, 0.0);
        if (hit.found) {
            // The back of a surface of one side is dark.
            arriving = vec4f(select(vec3f(0.0), unpack_radiance(side_radiance[hit.side]), hit.shown), 1.0);
            distance = min(distance, hit.distance);
        }
        if (MEETS_LAMPS && lobe.shape == LOBE_GGX) {
            let met = select(1e30, hit.distance, hit.found);
            arriving += vec4f(lamps_along(lobe, origin.point, direction, met, trace_params.rays), 0.0);
        }
        sum += arriving;
        vector += vector_of(lobe, direction, arriving.rgb);
    }
    let mean = sum / f32(trace_params.rays);
    let lamp_rays = select(0u, trace_params.rays, MEETS_LAMPS);
    return Gathered(mean.rgb, mean.a, distance, vector / f32(trace_params.rays), lamp_rays);
}

fn trace_opacity(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32) -> f32 {
    let origin = leave(apex);
    var sum = 0.0;
    for (var i = 0u; i < trace_params.rays; i++) {
        var direction: vec3f;
        let hit = shoot(apex, lobe, reach, origin, i, &direction);
        sum += select(0.0, 1.0 / (1.0 + falloff * hit.distance), hit.found);
    }
    return sum / f32(trace_params.rays);
}
