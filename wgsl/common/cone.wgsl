// Voxel cone tracing (RAU §6.1, DVS §4). Lengths are voxels of level 0. A cone composites samples front to
// back: c += T·c₂, T −= T·α₂ with premultiplied c₂ (DVS §4, corrected).

import package::common::frame::frame;
import package::format::sample::{VOXEL_ONE_SIDED, voxel_sample};

// RAU's tangent spheres: each sample's sphere touches the one before it (RAU eq. of §6.1, r = d·sin(θ/2)).
const STEPPER_SPHERES = 1u;
// RAU §6.1.2 and figure B.5: distance and cell double from sample to sample; made for 60°.
const STEPPER_DOUBLING = 2u;
const COS_30 = 0.8660254;
// How much of a surface one doubling sample stands for. With 1, the shares of a wall sum to between 0.7 and 2 by how
// it lies to the samples, and cones leak; a factor, chosen by the least error on the Cornell box.
const SHARE = 1.4;
// How much narrower cells have to be where surfaces seen edgewise are a whole cell thick; a factor. With 1, diffuse light
// in the Cornell box is 5 points of its mean brighter.
const EDGEWISE = 0.5;

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

// Ends a cone before the filter finds the plane through a point that it runs to.
fn end_at_plane(cone: Cone, point_voxel: vec3f, normal: vec3f) -> Cone {
    let lift = filter_reach(normal);
    let cosine = max(-dot(normal, cone.direction), 1e-4);
    var c = cone;
    c.reach = (dot(cone.origin - point_voxel, normal) - lift) / cosine;
    c.end_growth = cosine / lift;
    return c;
}

// A cone that leaves a surface, from as far over it as the filter at level 0 reaches, times `start`.
fn surface_cone(p_voxel: vec3f, normal: vec3f, direction: vec3f, sine: f32, reach: f32, start: f32) -> Cone {
    let lift = filter_reach(normal);
    let growth = max(dot(normal, direction), 0.0) / lift;
    return Cone(p_voxel + normal * (lift * start), direction, sine, 0.0, reach - lift * start, start, growth, 1.0);
}

// The widest level, whole, whose linear filter neither reaches back to the surface left nor on to the end.
fn clear_level(cone: Cone, t: f32) -> f32 {
    // The sample lies up to half a cell nearer to the end than t.
    var clearance = cone.end_growth * (cone.reach - t) / (1.0 + 0.5 * cone.end_growth);
    if (!VOXEL_ONE_SIDED) {
        // Without sides, a cell that a surface passes is opaque throughout, along the surface too: neighbours of the
        // point stand a cell high, and show up in cells that just clear its plane.
        clearance = EDGEWISE * min(clearance, cone.clearance + cone.clearance_growth * t);
    }
    return floor(min(log2(max(clearance, 1.0)), f32(frame.level_count - 1)));
}

// A sample of a cone: where, on which level, and for how much of the axis it stands.
struct ConeStep {
    at: f32,
    level: f32,
    length: f32,
    next: f32,
    // Whether it is a share of what is found, else a layer in front of the next.
    adds: bool,
}

fn cone_step(cone: Cone, settings: ConeSettings, t: f32) -> ConeStep {
    let clear = clear_level(cone, t);
    let doubling = floor(log2(max(t, 1.0)) + 0.5);
    if (settings.stepper == STEPPER_DOUBLING && doubling <= clear) {
        // As wide as a cone of 60° is there: the cell is 2·t·tan 30°.
        let cell = exp2(doubling);
        return ConeStep(cell * COS_30, doubling, SHARE * cell, 2.0 * cell, true);
    }
    let width = 2.0 * cone.sine * t / max(1.0 - settings.step * cone.sine, 0.1);
    let level = min(log2(max(width, 1.0)), clear);
    let length = min(settings.step * exp2(level), max(cone.reach - t, 0.01));
    return ConeStep(t + 0.5 * length, level, length, t + length, false);
}

// Opacity through `length` of cells that have opacity `alpha` over `cell`: α' = 1 − (1 − α)^(length/cell).
fn opacity_over(alpha: f32, ratio: f32) -> f32 {
    return 1.0 - pow(1.0 - min(alpha, 0.9999), ratio);
}

// Premultiplied radiance, and Σ T·α·f with f = 1/(1 + falloff·t): the opacity where falloff is 0.
fn cone_trace(cone: Cone, settings: ConeSettings, falloff: f32) -> vec4f {
    let grid = vec3f(frame.grid_size);
    var gathered = vec4f(0.0);
    var transmittance = 1.0;
    var before = 1.0;
    var t = cone.start;
    if (VOXEL_ONE_SIDED && settings.stepper == STEPPER_DOUBLING) {
        // From level 1 on: what level 0 would find nearer is the surface left.
        t = max(t, 2.0);
    }
    for (var i = 0; i < 512 && t < cone.reach && transmittance > 0.004; i++) {
        let s = cone_step(cone, settings, t);
        let p = cone.origin + s.at * cone.direction;
        let cell = exp2(s.level);
        // Beyond the outermost cells' centres the sampler repeats them: fade them out as empty neighbours would.
        let beyond = max(abs(p - 0.5 * grid) - 0.5 * (grid - cell), vec3f(0.0)) / cell;
        let fade = max(1.0 - beyond, vec3f(0.0));
        let inside_grid = fade.x * fade.y * fade.z;
        if (inside_grid <= 0.0) {
            break;
        }
        let value = voxel_sample(p / grid, s.level, cone.direction) * inside_grid;
        var behind = transmittance;
        if (value.a > 0.0) {
            // Doubling cones take few samples, each the share of a surface that its filter finds: shares add up.
            // Spheres follow each other as layers do; but a linear filter shows a surface to two of them in turn, so each
            // is composited with what was in front of its predecessor: a wall's two shares add up to all of it.
            let ratio = s.length / cell;
            let layer = before * opacity_over(value.a, ratio);
            let weight = min(transmittance, select(layer, value.a * ratio, s.adds));
            gathered += vec4f(value.rgb * (weight / value.a), weight / (1.0 + falloff * s.at));
            behind = transmittance - weight;
        }
        before = transmittance;
        transmittance = behind;
        t = s.next;
    }
    return gathered;
}
