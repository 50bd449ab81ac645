//! `wgsl/common/coverage.wgsl`.

use glam::DVec3;

/// The share of a parent that its eight children cover, seen along x, y and z: along each axis the nearer child hides
/// the farther, and the four columns average.
pub fn composite_coverage(opacity: &[DVec3; 8]) -> DVec3 {
    let over = |near: f64, far: f64| near + (1.0 - near) * far;
    (0..4)
        .map(|column| {
            let (low, high) = (column & 1, column >> 1);
            DVec3::new(
                over(opacity[2 * column].x, opacity[2 * column + 1].x),
                over(opacity[low + 4 * high].y, opacity[low + 4 * high + 2].y),
                over(opacity[column].z, opacity[column + 4].z),
            )
        })
        .sum::<DVec3>()
        / 4.0
}
