//! `wgsl/common/coverage.wgsl`.

use glam::{DVec3, DVec4};

/// What a parent shows of its eight children along an axis: the nearer child hides the farther, and the four columns average.
/// The observer is on the side of the children whose coordinate along the axis is `near`, 0 or 1.
pub fn composite_columns(children: &[DVec4; 8], axis: usize, near: usize) -> DVec4 {
    let column = |low: usize| {
        let first = children[low | near << axis];
        first + (1.0 - first.w) * children[low | (1 - near) << axis]
    };
    (0..8).filter(|i| i >> axis & 1 == 0).map(column).sum::<DVec4>() / 4.0
}

/// The share of a parent that children of these opacities along x, y and z cover.
pub fn composite_coverage(opacity: &[DVec3; 8]) -> DVec3 {
    let along = |axis: usize| composite_columns(&opacity.map(|of| DVec4::splat(of[axis])), axis, 0).w;
    DVec3::new(along(0), along(1), along(2))
}
