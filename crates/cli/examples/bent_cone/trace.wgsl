// Bent cones: a few short rays find out which part of a lobe is open near its apex, and one cone through the volume stands for
// all that lies beyond, along the mean direction of those that found nothing.

import package::common::environment::environment;
import package::common::grid::grid;
import package::common::radiance::unpack_radiance;
import package::common::ray::{Ray, Tangent, leave};
import package::common::trace::{Apex, Gathered, LOBE_HEMISPHERE, Lobe, Reach, vector_of};
import package::format::sample::voxel_sample;
import package::tracer::rays::{feeler_direction, trace_params};
import package::walk::first_hit;

// What every side of a voxel sends.
var<storage, read> side_radiance: array<u32>;

// The open part of a lobe.
struct Bent {
    // Of what the feelers met: the sum of radiance and opacity; then how many met nothing, and the sum of their directions.
    near: vec4f,
    open: f32,
    axis: vec3f,
    distance: f32,
}

fn feel(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32) -> Bent {
    let origin = leave(apex);
    let length = min(trace_params.feel, reach.distance);
    var bent = Bent(vec4f(0.0), 0.0, vec3f(0.0), reach.distance);
    for (var i = 0u; i < trace_params.feelers; i++) {
        let direction = feeler_direction(lobe, i, apex.share);
        let hit = first_hit(Ray(origin.point, direction, length, origin, Tangent(reach.point, reach.normal)));
        if (hit.found) {
            let radiance = select(vec3f(0.0), unpack_radiance(side_radiance[hit.side]), hit.shown);
            bent.near += vec4f(radiance, 1.0 / (1.0 + falloff * hit.distance));
            bent.distance = min(bent.distance, hit.distance);
        } else {
            bent.open += 1.0;
            bent.axis += direction;
        }
    }
    return bent;
}

// Radiance and opacity along a cone: tangent spheres from where the feelers end (RAU §6.1).
fn cone(apex: Apex, axis: vec3f, half_sine: f32, reach: Reach, falloff: f32) -> vec4f {
    var sum = vec4f(0.0);
    var transmittance = 1.0;
    var t = trace_params.feel;
    for (var i = 0; i < 64 && t < reach.distance && transmittance > 0.01; i++) {
        let cell = max(2.0 * half_sine * t, 1.0);
        let length = min(cell, reach.distance - t);
        let p = apex.position + (t + 0.5 * length) * axis;
        if (any(p < vec3f(0.0)) || any(p > vec3f(grid.size))) {
            break;
        }
        let level = min(log2(cell), f32(grid.level_count - 1));
        let value = voxel_sample(p / vec3f(grid.size), level, axis);
        // Of a cell that the reach cuts, the share that lies before it.
        let share = length / cell;
        sum += transmittance * share * vec4f(value.rgb, value.a / (1.0 + falloff * t));
        transmittance *= 1.0 - share * value.a;
        t += length;
    }
    return sum + vec4f(transmittance * environment.sky, 0.0);
}

// Mean radiance and opacity of a lobe, and the nearest that the feelers met.
fn bent_mean(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32, distance: ptr<function, f32>) -> vec4f {
    let bent = feel(apex, lobe, reach, falloff);
    *distance = bent.distance;
    var sum = bent.near;
    if (bent.open > 0.0) {
        let length = length(bent.axis) / bent.open;
        // A hemisphere's directions have a mean of length 2/3, and a single one of length 1: the cone is as wide as the open part,
        // up to 60°.
        let half_sine = select(lobe.width, sqrt(max(1.0 - length * length, 0.0)), lobe.shape == LOBE_HEMISPHERE);
        sum += bent.open * cone(apex, normalize(bent.axis), min(half_sine, 0.5), reach, falloff);
    }
    return sum / f32(trace_params.feelers);
}

fn trace_gather(apex: Apex, lobe: Lobe, reach: Reach) -> Gathered {
    var distance: f32;
    let mean = bent_mean(apex, lobe, reach, 0.0, &distance);
    return Gathered(mean.rgb, mean.a, distance, vector_of(lobe, lobe.axis, mean.rgb), false);
}

fn trace_opacity(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32) -> f32 {
    var distance: f32;
    return bent_mean(apex, lobe, reach, falloff, &distance).a;
}
