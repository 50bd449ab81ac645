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
    // Height of `origin` over the surface that the cone leaves, and gain of height along the axis.
    lift: f32,
    slope: f32,
}

// The cell whose width is the cone's, given the distance of its near side; a linear filter reaches one
// cell beyond, so it may be no wider than the way back to the surface left or on to the end.
fn cell_size(cone: Cone, t: f32, step: f32) -> f32 {
    let width = 2.0 * cone.sine * t / max(1.0 - step * cone.sine, 0.1);
    let clearance = cone.lift + cone.slope * t - 0.5;
    let widest = f32(max(frame.grid_size.x, max(frame.grid_size.y, frame.grid_size.z)));
    return clamp(min(width, min(clearance, cone.reach - t)), 1.0, widest);
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
        var cell = t;
        var length = t;
        var at = t;
        if (!doubling) {
            cell = cell_size(cone, t, settings.step);
            length = min(settings.step * cell, max(cone.reach - t, 0.01));
            at = t + 0.5 * length;
        }
        let p = cone.origin + at * cone.direction;
        if (any(p < vec3f(0.0)) || any(p > grid)) {
            break;
        }
        let value = voxel_sample(p / grid, log2(max(cell, 1.0)), cone.direction);
        if (value.a > 0.0) {
            let alpha = opacity_over(value.a, length / max(cell, 1.0));
            let weight = transmittance * alpha;
            gathered += vec4f(value.rgb * (weight / value.a), weight / (1.0 + falloff * at));
            transmittance *= 1.0 - alpha;
        }
        t += length;
    }
    return gathered;
}
