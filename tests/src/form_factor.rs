//! Form factors from a small patch: the share of the light of an even hemisphere that a shape takes.

use std::f64::consts::PI;

/// Of a rectangle parallel to the patch at a distance, whose sides are at `x` and `y` from the patch's foot.
pub fn of_rectangle(x: [f64; 2], y: [f64; 2], distance: f64) -> f64 {
    // From the foot to (a, b).
    let corner = |a: f64, b: f64| {
        let [p, q] = [a, b].map(|side: f64| side.hypot(distance));
        (a / p * (b / p).atan() + b / q * (a / q).atan()) / (2.0 * PI)
    };
    corner(x[1], y[1]) - corner(x[0], y[1]) - corner(x[1], y[0]) + corner(x[0], y[0])
}
