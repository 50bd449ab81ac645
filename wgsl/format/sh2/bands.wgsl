// The two bands summed up in a direction (RAU §5.2.3). Two bands of a one-sided emitter overshoot to 1.25 ahead and −0.25
// behind. So radiance is divided by what the same two bands give for a radiance of 1, which makes it exact for surfaces of one
// radiance. What is negative is clamped to zero, or band 1 is windowed so that nothing is: of a one-sided emitter 2/3 of
// it remains, which gives 1 ahead and 0 behind.

import package::format::cell::{Cell, emitter};
import package::format::options::{NEGATIVES, NEGATIVES_WINDOW};

// In a direction, unit, in which light leaves; of band 1 this share. SH₀·2√π is 1 and SH₁·√(3π)/2 is 3/4.
fn bands_towards(cell: Cell, direction: vec3f, share: vec3f) -> vec3f {
    return cell.band0 + 0.75 * share * (cell.band1 * direction);
}

// The largest share of band 1, [0, 1], with which nothing is negative in any direction; of each channel.
fn window(band0: vec3f, size1: vec3f) -> vec3f {
    if (NEGATIVES != NEGATIVES_WINDOW) {
        return vec3f(1.0);
    }
    return saturate(band0 / max(size1, vec3f(1e-20)));
}

// In a direction of travel, no less than 0.
fn bands_against(c: Cell, direction: vec3f) -> vec3f {
    let size1 = sqrt(c.band1[0] * c.band1[0] + c.band1[1] * c.band1[1] + c.band1[2] * c.band1[2]);
    return max(bands_towards(c, -direction, window(c.band0, 0.75 * size1)), vec3f(0.0));
}

fn radiance_by_bands(c: Cell, direction: vec3f) -> vec3f {
    let one = emitter(vec3f(1.0), c.positive, c.negative);
    return bands_against(c, direction) / max(bands_against(one, direction).x, 0.35 * one.band0.x + 1e-6);
}
