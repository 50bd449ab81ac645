//! The same in `f64`.

use std::f64::consts::PI;

use glam::{DVec3, DVec4, UVec3};
use voxlume::Twin;
use voxlume::twin::{Volumes, children, composite_coverage};

use crate::Sh3;

const BASE: usize = 0;
const NINE: usize = 1;
const BANDS: u32 = 9;
const COSINE2: f64 = 0.15625;

/// The functions' factors, times 16/3.
fn factors() -> [f64; 5] {
    let root = PI.sqrt() * 3.0 / 16.0;
    [
        1.0 / (2.0 * root),
        3f64.sqrt() / (2.0 * root),
        15f64.sqrt() / (2.0 * root),
        5f64.sqrt() / (4.0 * root),
        15f64.sqrt() / (4.0 * root),
    ]
}

fn harmonics(d: DVec3) -> [f64; 9] {
    let [y0, y1, y2, y20, y22] = factors();
    [
        y0,
        y1 * d.x,
        y1 * d.y,
        y1 * d.z,
        y2 * d.x * d.y,
        y2 * d.y * d.z,
        y2 * d.x * d.z,
        y20 * (3.0 * d.z * d.z - 1.0),
        y22 * (d.x * d.x - d.y * d.y),
    ]
}

fn area_coefficients(normal: DVec3, front: DVec3, back: DVec3) -> [f64; 9] {
    let [y0, y1, y2, y20, y22] = factors();
    let (both, odd) = (front + back, front - back);
    let flat = normal != DVec3::ZERO;
    let sum = both.element_sum();
    let area = if flat { sum / normal.abs().element_sum().max(1.0) } else { sum };
    let square = if flat { area * normal * normal } else { both };
    [
        0.25 / y0 * area,
        0.5 / y1 * odd.x,
        0.5 / y1 * odd.y,
        0.5 / y1 * odd.z,
        6.0 * COSINE2 / y2 * area * normal.x * normal.y,
        6.0 * COSINE2 / y2 * area * normal.y * normal.z,
        6.0 * COSINE2 / y2 * area * normal.x * normal.z,
        COSINE2 / y20 * (square.z - 0.5 * (square.x + square.y)),
        1.5 * COSINE2 / y22 * (square.x - square.y),
    ]
}

fn child_coefficients(volumes: &Volumes, cell: UVec3, level: u32) -> [DVec4; 9] {
    if level > 1 {
        return std::array::from_fn(|k| volumes.load_block(NINE, level - 1, cell, k as u32));
    }
    let value = volumes.level(BASE, 0).load(cell);
    let Some(surface) = volumes.surface(cell).filter(|_| value.w > 0.0) else { return [DVec4::ZERO; 9] };
    area_coefficients(surface.normal, surface.front, surface.back).map(|c| value * c)
}

fn along(c: &[DVec4; 9], d: DVec3) -> DVec4 {
    harmonics(d).into_iter().zip(c).map(|(y, c)| y * *c).sum()
}

fn sample_nine(volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
    let c = std::array::from_fn(|k| volumes.sample_block(NINE, k as u32, uvw, level));
    let sum = along(&c, -direction);
    let opacity = sum.w.clamp(0.0, 1.0);
    (sum.truncate().max(DVec3::ZERO) * (opacity / sum.w.max(1e-6))).extend(opacity)
}

impl Twin for Sh3 {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, _: DVec3, opacity: f64) {
        volumes.level_mut(BASE, 0).store(cell, (radiance * opacity).extend(opacity));
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        let child = children(cell).map(|child| child_coefficients(volumes, child, level));
        let side = |sign: f64| {
            child.map(|c| DVec3::AXES.map(|axis| along(&c, sign * axis).w.clamp(0.0, 1.0)).into())
        };
        let (positive, negative) = (side(1.0), side(-1.0));
        let before: f64 = positive.iter().chain(&negative).map(|side: &DVec3| side.element_sum()).sum();
        let after = (composite_coverage(&positive) + composite_coverage(&negative)).element_sum();
        for k in 0..BANDS {
            let sum: DVec4 = child.iter().map(|c| c[k as usize]).sum();
            volumes.store_block(NINE, level, cell, k, sum * (after / before.max(1e-6)));
        }
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let coarse = sample_nine(volumes, uvw, (level - 1.0).max(0.0), direction);
        if level >= 1.0 { coarse } else { volumes.sample_over_base(BASE, uvw, level, coarse) }
    }
}
