// Where a cone takes its samples: how far along, how coarse, and for how much of the axis each stands. Lengths are voxels of
// level 0.

import package::common::cone::{Cone, ConeSettings, STEPPER_DOUBLING};
import package::common::grid::grid;
import package::format::sample::VOXEL_ONE_SIDED;

const COS_30 = 0.8660254;
// How much of a surface one doubling sample stands for. With 1, the shares of a wall sum to between 0.7 and 2 by how
// it lies to the samples, and cones leak; a factor: the least with which `stability`'s sealed boxes hold. With 1.4, diffuse light in
// the Cornell box has an RMSE 2 to 4 % smaller.
const SHARE = 1.5;
// How much narrower cells have to be where surfaces seen edgewise are a whole cell thick; a factor. With 1, diffuse light
// in the Cornell box is 5 points of its mean brighter.
const EDGEWISE = 0.5;

// The widest level, whole, whose linear filter neither reaches back to the surface left nor on to the end.
fn clear_level(cone: Cone, t: f32) -> f32 {
    // The sample lies up to half a cell nearer to the end than t.
    var clearance = cone.end_growth * (cone.reach - t) / (1.0 + 0.5 * cone.end_growth);
    if (!VOXEL_ONE_SIDED) {
        // Without sides, a cell that a surface passes is opaque throughout, along the surface too: neighbours of the
        // point stand a cell high, and show up in cells that just clear its plane.
        clearance = EDGEWISE * min(clearance, cone.clearance + cone.clearance_growth * t);
    }
    return floor(min(log2(max(clearance, 1.0)), f32(grid.level_count - 1)));
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

// Beyond the outermost cells' centres the sampler repeats them: fade them out as empty neighbours would.
fn share_inside(p: vec3f, cell: f32) -> f32 {
    let size = vec3f(grid.size);
    let beyond = max(abs(p - 0.5 * size) - 0.5 * (size - cell), vec3f(0.0)) / cell;
    let share = max(1.0 - beyond, vec3f(0.0));
    return share.x * share.y * share.z;
}
