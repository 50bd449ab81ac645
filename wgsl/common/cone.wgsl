// Voxel cone tracing (RAU §6.1, DVS §4). Lengths are voxels of level 0. A cone composites samples front to
// back: c += T·c₂, T −= T·α₂ with premultiplied c₂ (DVS §4, corrected).

import package::common::cone_step::{cone_step, opacity_over, share_inside};
import package::common::grid::grid;
import package::common::seen_ahead::{SeenAhead, all_ahead};
import package::format::sample::{VOXEL_ONE_SIDED, voxel_sample, voxel_sample_ahead};

// RAU's tangent spheres: each sample's sphere touches the one before it (RAU eq. of §6.1, r = d·sin(θ/2)).
const STEPPER_SPHERES = 1u;
// RAU §6.1.2 and figure B.5: distance and cell double from sample to sample; made for 60°.
const STEPPER_DOUBLING = 2u;
// Transmittance at which a cone ends: what it met stands for the rest.
const CLOSED = 0.004;
// The share of what a cone meets that has to be known to lie ahead of it for all of it to count; a factor.
const KNOWN = 0.1;

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

// As `cone_trace`; without `lit` only the opacity counts.
fn trace(cone: Cone, settings: ConeSettings, falloff: f32, lit: bool) -> vec4f {
    let size = vec3f(grid.size);
    // Apart, so that what needs opacity alone fetches nothing else.
    var radiance = vec3f(0.0);
    var opacity = 0.0;
    // Through all that is met, and through what is known to lie ahead, which alone is seen.
    var transmittance = vec2f(1.0);
    var before = vec2f(1.0);
    var hidden = vec3f(0.0);
    var t = cone.start;
    if (VOXEL_ONE_SIDED && settings.stepper == STEPPER_DOUBLING) {
        // From level 1 on: what level 0 would find nearer is the surface left.
        t = max(t, 2.0);
    }
    for (var i = 0; i < 512 && t < cone.reach && transmittance.y > CLOSED; i++) {
        let s = cone_step(cone, settings, t);
        let p = cone.origin + s.at * cone.direction;
        let cell = exp2(s.level);
        let inside_grid = share_inside(p, cell);
        if (inside_grid <= 0.0) {
            break;
        }
        var found: SeenAhead;
        if (lit) {
            found = voxel_sample_ahead(p / size, s.level, cone.direction, cone.origin / size, hidden);
            hidden = found.behind;
        } else {
            found = all_ahead(voxel_sample(p / size, s.level, cone.direction));
        }
        // Doubling cones take few samples, each the share of a surface that its filter finds: shares add up.
        // Spheres follow each other as layers do; but a linear filter shows a surface to two of them in turn, so each
        // is composited with what was in front of its predecessor: a wall's two shares add up to all of it.
        let ratio = s.length / cell;
        let alpha = vec2f(found.value.a, found.known) * inside_grid;
        let layer = before * vec2f(opacity_over(alpha.x, ratio), opacity_over(alpha.y, ratio));
        let weight = min(transmittance, select(layer, alpha * ratio, s.adds));
        radiance += found.value.rgb * (weight.y / max(found.known, 1e-6));
        opacity += weight.x / (1.0 + falloff * s.at);
        before = transmittance;
        transmittance -= weight;
        t = s.next;
    }
    let met = 1.0 - transmittance;
    // What is met and unknown is taken to be as bright as what is known; where hardly anything is known all lies behind.
    let told = min(met.y / max(KNOWN * met.x, 1e-6), 1.0);
    let whole = select(1.0, 1.0 / met.x, transmittance.x <= CLOSED);
    return vec4f(radiance * (met.x / max(met.y, 1e-6)), opacity) * (told * whole);
}

// Premultiplied radiance, and Σ T·α·f with f = 1/(1 + falloff·t): the opacity where falloff is 0.
fn cone_trace(cone: Cone, settings: ConeSettings, falloff: f32) -> vec4f {
    return trace(cone, settings, falloff, true);
}

// The opacity of `cone_trace` alone, in less time.
fn cone_opacity(cone: Cone, settings: ConeSettings, falloff: f32) -> f32 {
    return trace(cone, settings, falloff, false).a;
}
