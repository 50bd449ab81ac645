// Rays through the occupancy bitmask (VGI §4.2): a lobe is the mean over rays in it, each to the first surface that it meets.
// What is met sends what the storage format's finest level says of its own voxel: no filter reaches through a wall.

import package::common::environment::environment;
import package::common::grid::grid;
import package::common::ray::{Ray, RayHit, Tangent};
import package::common::trace::{Apex, Gathered, Lobe, Reach};
import package::format::sample::voxel_sample;
import package::meet::{arrive, leave};
import package::tracer::lobe::{lobe_direction, trace_params};
import package::walk::first_hit;

// What a ray of a trace meets. What lies below the surface is looked for above it, as in a mirror.
fn shoot(apex: Apex, lobe: Lobe, reach: Reach, origin: Tangent, index: u32, direction: ptr<function, vec3f>) -> RayHit {
    let wanted = lobe_direction(lobe, index, apex.turn);
    let below = min(dot(wanted, apex.normal), 0.0);
    *direction = wanted - 2.0 * below * apex.normal;
    let goal = Tangent(reach.point, reach.normal);
    var distance = reach.distance;
    if (any(goal.normal != vec3f(0.0))) {
        distance = arrive(*direction, origin.point, goal);
    }
    return first_hit(Ray(origin.point, *direction, distance, origin, goal), 0);
}

// Radiance that a voxel's surface sends against a direction. What is met hides all that lies behind: the format's share of
// opacity says nothing of it.
fn sent(hit: RayHit, direction: vec3f) -> vec3f {
    if (!hit.shown) {
        return vec3f(0.0);
    }
    let value = voxel_sample((vec3f(hit.cell) + 0.5) / vec3f(grid.size), 0.0, direction);
    return value.rgb / max(value.a, 1e-3);
}

fn trace_gather(apex: Apex, lobe: Lobe, reach: Reach) -> Gathered {
    let origin = leave(apex);
    var sum = vec4f(0.0);
    var distance = reach.distance;
    for (var i = 0u; i < trace_params.rays; i++) {
        var direction: vec3f;
        let hit = shoot(apex, lobe, reach, origin, i, &direction);
        if (hit.found) {
            sum += vec4f(sent(hit, direction), 1.0);
            distance = min(distance, hit.distance);
        } else {
            sum += vec4f(environment.sky, 0.0);
        }
    }
    let mean = sum / f32(trace_params.rays);
    return Gathered(mean.rgb, mean.a, distance);
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
