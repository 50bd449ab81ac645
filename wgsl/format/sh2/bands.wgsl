// The two bands summed up in a direction. What is negative is clamped to zero, or band 1 windowed so that nothing is: of a
// one-sided emitter 2/3 of it remains, which gives 1 ahead and 0 behind.

import package::format::cell::Cell;
import package::format::options::{NEGATIVES, NEGATIVES_WINDOW};

// The two bands' sum in a direction, unit, in which light leaves; of band 1 this share. A facet of radiance 1 sends 1.25 ahead
// and −0.25 back: SH₀·2√π is 1 and SH₁·√(3π)/2 is 3/4.
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

// The two bands in a direction of travel, no less than 0.
fn bands_against(c: Cell, direction: vec3f) -> vec3f {
    let size1 = sqrt(c.band1[0] * c.band1[0] + c.band1[1] * c.band1[1] + c.band1[2] * c.band1[2]);
    return max(bands_towards(c, -direction, window(c.band0, 0.75 * size1)), vec3f(0.0));
}

// Divided by what the same bands give for a radiance of 1, which makes it exact for surfaces of one radiance.
fn radiance_by_bands(c: Cell, direction: vec3f) -> vec3f {
    let sides = c.positive + c.negative;
    let more = c.positive - c.negative;
    let half_sum = 0.5 * (sides.x + sides.y + sides.z);
    let one = Cell(vec3f(half_sum), mat3x3f(vec3f(more.x), vec3f(more.y), vec3f(more.z)), c.positive, c.negative);
    return bands_against(c, direction) / max(bands_against(one, direction).x, 0.35 * half_sum + 1e-6);
}
