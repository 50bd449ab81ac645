// Voxel cone tracing (RAU §6.1, DVS §4). Lengths are voxels of level 0. A cone composites samples front to
// back: c += T·c₂, T ·= 1 − α₂ with premultiplied c₂.

import package::common::frame::frame;
import package::format::sample::voxel_sample;

// RAU's tangent spheres: each sample's sphere touches the one before it (RAU eq. of §6.1, r = d·sin(θ/2)).
const STEPPER_SPHERES = 1u;
// RAU §6.1.2 and figure B.5: distance and cell double from sample to sample; made for 60°.
const STEPPER_DOUBLING = 2u;

struct ConeSettings {
    stepper: u32,
    // Step over cell size, (0, 1]; only of the tangent spheres.
    step: f32,
}

struct Cone {
    origin: vec3f,
    // Unit.
    direction: vec3f,
    // Sine of half the aperture, [0, 1].
    sine: f32,
    // Distances along the axis between which it gathers.
    start: f32,
    reach: f32,
    // The widest cell that doesn't reach back to the surface that the cone leaves: at the origin, and its
    // growth along the axis.
    clearance: f32,
    clearance_growth: f32,
    // Likewise for what it ends at: growth with the distance from the end.
    end_growth: f32,
}

// How far over a surface of this normal a linear filter over cells of size 1 still finds it: the topmost cell that
// the surface touches has its centre at most |n|₁/2 over it, and the filter reaches |n|₁ further.
fn filter_reach(normal: vec3f) -> f32 {
    return 1.5 * (abs(normal.x) + abs(normal.y) + abs(normal.z));
}

// Ends a cone before the filter finds a surface of this normal that its axis meets at `reach`.
fn end_at_surface(cone: Cone, normal: vec3f) -> Cone {
    let lift = filter_reach(normal);
    let cosine = max(-dot(normal, cone.direction), 1e-4);
    var c = cone;
    c.reach -= lift / cosine;
    c.end_growth = cosine / lift;
    return c;
}

// A cone that leaves a surface, from as far over it as the filter at level 0 reaches, times `start`.
fn surface_cone(p_voxel: vec3f, normal: vec3f, direction: vec3f, sine: f32, reach: f32, start: f32) -> Cone {
    let lift = filter_reach(normal);
    let growth = max(dot(normal, direction), 0.0) / lift;
    return Cone(p_voxel + normal * (lift * start), direction, sine, 0.0, reach - lift * start, start, growth, 1.0);
}

// The level whose cells are about as wide as the cone, given the distance of its near side, but no wider than the
// way back to the surface left or on to the end. Whole levels: a mix of two would reach as far as the coarser.
fn cone_level(cone: Cone, t: f32, step: f32) -> f32 {
    let width = 2.0 * cone.sine * t / max(1.0 - step * cone.sine, 0.1);
    let clearance = min(cone.clearance + cone.clearance_growth * t, cone.end_growth * (cone.reach - t));
    let level = floor(min(log2(max(width, 1.0)) + 0.5, log2(max(clearance, 1.0))));
    return min(level, f32(frame.level_count - 1));
}

// Opacity through `length` of cells that have opacity `alpha` over `cell`: α' = 1 − (1 − α)^(length/cell).
fn opacity_over(alpha: f32, ratio: f32) -> f32 {
    return 1.0 - pow(1.0 - min(alpha, 0.9999), ratio);
}

// Premultiplied radiance, and Σ T·α·f with f = 1/(1 + falloff·t): the opacity where falloff is 0.
fn cone_trace(cone: Cone, settings: ConeSettings, falloff: f32) -> vec4f {
    let grid = vec3f(frame.grid_size);
    let doubling = settings.stepper == STEPPER_DOUBLING;
    var gathered = vec4f(0.0);
    var transmittance = 1.0;
    var t = select(cone.start, max(cone.start, 1.0), doubling);
    for (var i = 0; i < 512 && t < cone.reach && transmittance > 0.004; i++) {
        var level = log2(max(t, 1.0));
        var length = t;
        var at = t;
        if (!doubling) {
            level = cone_level(cone, t, settings.step);
            length = min(settings.step * exp2(level), max(cone.reach - t, 0.01));
            at = t + 0.5 * length;
        }
        let p = cone.origin + at * cone.direction;
        if (any(p < vec3f(0.0)) || any(p > grid)) {
            break;
        }
        let value = voxel_sample(p / grid, level, cone.direction);
        if (value.a > 0.0) {
            let alpha = opacity_over(value.a, length / exp2(level));
            let weight = transmittance * alpha;
            gathered += vec4f(value.rgb * (weight / value.a), weight / (1.0 + falloff * at));
            transmittance *= 1.0 - alpha;
        }
        t += length;
    }
    return gathered;
}
