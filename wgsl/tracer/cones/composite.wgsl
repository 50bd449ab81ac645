// A cone composites samples front to back: c += T·c₂, T −= T·α₂ with
// premultiplied c₂ (DVS §4, corrected). Lengths are voxels of level 0.

import package::common::grid::grid;
import package::common::trace::Gathered;
import package::format::sample::voxel_sample;
import package::tracer::cone::Cone;
import package::tracer::step::cone_step;

// Transmittance at which a cone ends: what it met stands for the rest.
const CLOSED = 0.004;

// Opacity through `length` of cells that have opacity `alpha` over `cell`: α' = 1 − (1 − α)^(length/cell).
fn opacity_over(alpha: f32, ratio: f32) -> f32 {
    return 1.0 - pow(1.0 - min(alpha, 0.9999), ratio);
}

// Beyond the outermost cells' centres the sampler repeats them: fade them out as empty neighbours would.
fn share_inside(p: vec3f, cell: f32) -> f32 {
    let size = vec3f(grid.size);
    let beyond = max(abs(p - 0.5 * size) - 0.5 * (size - cell), vec3f(0.0)) / cell;
    let share = max(1.0 - beyond, vec3f(0.0));
    return share.x * share.y * share.z;
}

// Without `lit` only the opacity counts: Σ T·α/(1 + falloff·t).
fn composite_cone(cone: Cone, falloff: f32, lit: bool) -> Gathered {
    let size = vec3f(grid.size);
    // Apart, so that what needs opacity alone fetches nothing else.
    var radiance = vec3f(0.0);
    var opacity = 0.0;
    var distance = cone.reach;
    var transmittance = 1.0;
    var transmittance_before = 1.0;
    var t = 0.0;
    for (var i = 0; i < 512 && t < cone.reach && transmittance > CLOSED; i++) {
        let s = cone_step(cone, t);
        let p = cone.origin + s.at * cone.direction;
        let cell = exp2(s.level);
        let inside_grid = share_inside(p, cell);
        if (inside_grid <= 0.0) {
            break;
        }
        let value = voxel_sample(p / size, s.level, cone.direction);
        // Doubling cones take few samples, each the share of a surface that its filter finds: shares add up.
        // Spheres follow each other as layers do; but a linear filter shows a surface to two of them in turn, so each
        // is composited with what was in front of its predecessor: a wall's two shares add up to all of it.
        let ratio = s.length / cell;
        let alpha = value.a * inside_grid;
        let layer = transmittance_before * opacity_over(alpha, ratio);
        let weight = min(transmittance, select(layer, alpha * ratio, s.adds));
        if (lit) {
            radiance += value.rgb * (weight / max(value.a, 1e-6));
        }
        opacity += weight / (1.0 + falloff * s.at);
        distance = select(distance, s.at, weight > 0.0 && s.at < distance);
        transmittance_before = transmittance;
        transmittance -= weight;
        t = s.next;
    }
    let whole = select(1.0, 1.0 / (1.0 - transmittance), transmittance <= CLOSED);
    return Gathered(radiance * whole, opacity * whole, distance, vec3f(0.0), false);
}
