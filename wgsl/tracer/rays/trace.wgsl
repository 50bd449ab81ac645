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

// What lies below the surface is looked for above it, as in a mirror.
fn above(direction: vec3f, normal: vec3f) -> vec3f {
    return direction - 2.0 * min(dot(direction, normal), 0.0) * normal;
}

// What a ray of a trace meets.
fn shoot(reach: Reach, origin: Tangent, direction: vec3f) -> RayHit {
    let goal = Tangent(reach.point, reach.normal);
    var distance = reach.distance;
    if (any(goal.normal != vec3f(0.0))) {
        distance = arrive(direction, origin.point, goal);
    }
    return first_hit(Ray(origin.point, direction, distance, origin, goal));
}

fn trace_gather(apex: Apex, lobe: Lobe, reach: Reach) -> Gathered {
    let origin = leave(apex);
    var sum = vec4f(0.0);
    var vector = vec3f(0.0);
    var distance = reach.distance;
    var count = 0.0;
    for (var i = 0u; i < trace_params.rays; i++) {
        let wanted = lobe_direction(lobe, i, apex.share);
        let below = dot(wanted, apex.normal) <= 0.0;
        // Of mirror directions only those above the surface count, unless there is none.
        if (lobe.shape == LOBE_GGX && below && (count > 0.0 || i + 1 < trace_params.rays)) {
            continue;
        }
        let direction = above(wanted, apex.normal);
        let hit = shoot(reach, origin, direction);
        var arriving = vec4f(environment.sky, 0.0);
        if (hit.found) {
            // The back of a surface of one side is dark.
            arriving = vec4f(select(vec3f(0.0), unpack_radiance(side_radiance[hit.side]), hit.shown), 1.0);
            distance = min(distance, hit.distance);
        }
        if (MEETS_LAMPS && lobe.shape == LOBE_GGX) {
            arriving += vec4f(lamps_along(lobe, origin.point, direction, hit), 0.0);
        }
        sum += arriving;
        vector += vector_of(lobe, direction, arriving.rgb);
        count += 1.0;
    }
    let mean = sum / count;
    return Gathered(mean.rgb, mean.a, distance, vector / count, MEETS_LAMPS);
}

fn trace_opacity(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32) -> f32 {
    let origin = leave(apex);
    var sum = 0.0;
    for (var i = 0u; i < trace_params.rays; i++) {
        let hit = shoot(reach, origin, above(lobe_direction(lobe, i, apex.share), apex.normal));
        sum += select(0.0, 1.0 / (1.0 + falloff * hit.distance), hit.found);
    }
    return sum / f32(trace_params.rays);
}
