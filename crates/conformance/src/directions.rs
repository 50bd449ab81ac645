//! Directions all over the sphere.

use std::f64::consts::PI;

use glam::DVec3;

/// A Fibonacci lattice: `count` unit vectors, each of which stands for 4π/count of the sphere. Its least symmetric
/// error in the mean of |d·n| is below 2/count.
pub fn directions(count: usize) -> Vec<DVec3> {
    let golden = PI * (3.0 - 5f64.sqrt());
    (0..count)
        .map(|i| {
            let z = 1.0 - (2 * i + 1) as f64 / count as f64;
            let (sin, cos) = (golden * i as f64).sin_cos();
            DVec3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z)
        })
        .collect()
}
