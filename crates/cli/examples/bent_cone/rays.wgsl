// What a pass may choose, and the feelers' directions.

import package::common::basis::basis_around;
import package::common::constants::TAU;
import package::common::trace::{LOBE_GGX, LOBE_HEMISPHERE, Lobe, Share, turn_of};

struct TraceParams {
    /// Short rays of a trace, [1, 16]; 4 unless given.
    feelers: u32,
    /// How far they go, voxels, [1, 512]; 8 unless given.
    feel: f32,
}

var<uniform> trace_params: TraceParams;

// A ring by the cosine over a hemisphere, turned from pixel to pixel; of a cone or a mirrored lobe, its axis.
fn feeler_direction(lobe: Lobe, index: u32, share: Share) -> vec3f {
    if (lobe.shape == LOBE_GGX) {
        return reflect(-lobe.view, lobe.axis);
    }
    if (lobe.shape != LOBE_HEMISPHERE) {
        return lobe.axis;
    }
    let count = f32(trace_params.feelers);
    let radius = sqrt((f32(index) + fract(0.5 + turn_of(share) * 5.0)) / count);
    let azimuth = TAU * fract(f32(index) * 0.618034 + turn_of(share));
    return basis_around(lobe.axis) * vec3f(radius * cos(azimuth), radius * sin(azimuth), sqrt(1.0 - min(radius * radius, 1.0)));
}
