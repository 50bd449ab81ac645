// Where a cone takes its samples: how far along, how coarse, and for how much of the axis each stands. Lengths are voxels of
// level 0.

import package::tracer::cone::{Cone, clear_level};

struct TraceParams {
    /// 1: tangent spheres; 2: for cones of 60° those whose distance and cell double; `doubling` unless given.
    stepper: u32,
    /// Step over cell size, of the tangent spheres, (0, 1]; 1 unless given.
    step: f32,
    /// Where cones begin: 1 is where the filter no longer finds the own surface, [0, 4]; 1 unless given.
    start: f32,
    /// Cones around the axis of a hemisphere, [1, 8]; 5 unless given. Fewer stand for the ring of five, and neighbours turn
    /// them differently.
    ring: u32,
}

// RAU's tangent spheres: each sample's sphere touches the one before it (RAU eq. of §6.1, r = d·sin(θ/2)).
const STEPPER_SPHERES = 1u;
// RAU §6.1.2 and figure B.5: distance and cell double from sample to sample; made for 60°.
const STEPPER_DOUBLING = 2u;

var<uniform> trace_params: TraceParams;

const SINE_30 = 0.5;
const COSINE_30 = 0.8660254;
// How much of a surface one doubling sample stands for. With 1, the shares of a wall sum to between 0.7 and 2 by how
// it lies to the samples, and cones leak. With 1.4, diffuse light in the Cornell box has an RMSE 2 to 4 % smaller.
const SHARE = 1.5;

// A sample of a cone: where, on which level, and for how much of the axis it stands.
struct ConeStep {
    at: f32,
    level: f32,
    length: f32,
    next: f32,
    // Whether it is a share of what is found, else a layer in front of the next.
    adds: bool,
}

fn cone_step(cone: Cone, t: f32) -> ConeStep {
    let clear = clear_level(cone, t);
    let doubling = floor(log2(max(t, 1.0)) + 0.5);
    if (trace_params.stepper == STEPPER_DOUBLING && cone.half_sine == SINE_30 && doubling <= clear) {
        // As wide as a cone of 60° is there: the cell is 2·t·tan 30°.
        let cell = exp2(doubling);
        return ConeStep(cell * COSINE_30, doubling, SHARE * cell, 2.0 * cell, true);
    }
    let width = 2.0 * cone.half_sine * t / max(1.0 - trace_params.step * cone.half_sine, 0.1);
    let level = min(log2(max(width, 1.0)), clear);
    let length = min(trace_params.step * exp2(level), max(cone.reach - t, 0.01));
    return ConeStep(t + 0.5 * length, level, length, t + length, false);
}
