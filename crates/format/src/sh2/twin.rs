//! `wgsl/format/sh2`.

use glam::{DMat3, DVec3, DVec4, UVec3};

use crate::twin::{Twin, Volumes, children, composite_coverage};

/// See the module.
pub(super) struct Sh2Twin {
    pub(super) isotropic_base: bool,
    pub(super) projected: bool,
    pub(super) windowed: bool,
}

/// The two bands over 2√π and √(3π)/2, and opacities.
#[derive(Clone, Copy, Default)]
struct Cell {
    band0: DVec3,
    band1: [DVec3; 3],
    positive: DVec3,
    negative: DVec3,
}

impl Cell {
    /// Surfaces of one radiance, as opaque as this from the two sides of each axis.
    fn emitter(radiance: DVec3, positive: DVec3, negative: DVec3) -> Cell {
        let more = positive - negative;
        let facing = more * (more.abs().element_sum() / more.length().max(1e-6));
        Cell {
            band0: radiance * (0.5 * (positive + negative).element_sum()),
            band1: facing.to_array().map(|facing| radiance * facing),
            positive,
            negative,
        }
    }

    fn sides_opacity(&self) -> f64 {
        (self.positive + self.negative).element_sum()
    }

    /// The two bands' sum towards `direction`; of band 1 this share.
    fn bands_towards(&self, direction: DVec3, share: DVec3) -> DVec3 {
        self.band0 + 0.75 * share * (DMat3::from_cols_array_2d(&self.band1.map(|c| c.to_array())) * direction)
    }
}

/// RAU eq. 5.9 over π: what a child sends through its parent's six faces. `inwards` is 1 or −1 along each axis.
fn project_child(child: Cell, inwards: DVec3) -> Cell {
    const FAR_FACE: f64 = 1.0747930;
    const NEAR_FACE: f64 = 3.1139972;
    let mut projected = Cell { band0: DVec3::ZERO, band1: [DVec3::ZERO; 3], ..child };
    for face in 0..6 {
        let mut centre = inwards;
        centre[face / 2] += if face % 2 == 1 { -2.0 } else { 2.0 };
        let solid_angle = if centre[face / 2].abs() > 2.0 { FAR_FACE } else { NEAR_FACE };
        let d = centre.normalize();
        let share = child.bands_towards(d, DVec3::ONE) * (solid_angle / std::f64::consts::PI);
        projected.band0 += share / 4.0;
        (0..3).for_each(|axis| projected.band1[axis] += share * d[axis] * (2.0 / 3.0));
    }
    projected
}

/// What opacities are in bytes, unrounded: what is there at all keeps the least.
fn coverage_texel(opacity: DVec3) -> DVec4 {
    opacity.map(|a| if a > 0.0 { a.max(1.0 / 255.0) } else { 0.0 }).extend(0.0)
}

impl Sh2Twin {
    /// The volumes of coefficients and of opacities; `base`, where it is, comes first.
    fn harmonics(&self) -> usize {
        usize::from(self.isotropic_base)
    }

    fn coverage(&self) -> usize {
        self.harmonics() + 1
    }

    fn cell(&self, texel: impl Fn(usize, u32) -> DVec4) -> Cell {
        let more = [0, 1, 2].map(|axis| texel(self.harmonics(), axis));
        let [positive, negative] = [0, 1].map(|side| texel(self.coverage(), side).truncate());
        Cell {
            band0: DVec3::from_array(more.map(|more| more.w)),
            band1: more.map(DVec4::truncate),
            positive,
            negative,
        }
    }

    fn cell_at(&self, volumes: &Volumes, uvw: DVec3, level: f64) -> Cell {
        self.cell(|volume, block| volumes.sample_block(volume, block, uvw, level))
    }

    fn store(&self, volumes: &mut Volumes, place: UVec3, level: u32, cell: &Cell) {
        for (axis, more) in cell.band1.iter().enumerate() {
            let texel = more.extend(cell.band0[axis]);
            volumes.store_block(self.harmonics(), level, place, axis as u32, texel);
        }
        for (side, opacity) in [cell.positive, cell.negative].into_iter().enumerate() {
            volumes.store_block(self.coverage(), level, place, side as u32, coverage_texel(opacity));
        }
    }

    /// A voxel of level 0 with this premultiplied radiance and opacity.
    fn voxel(volumes: &Volumes, place: UVec3, value: DVec4) -> Cell {
        let Some(surface) = volumes.surface(place).filter(|_| value.w > 0.0) else { return Cell::default() };
        Cell::emitter(value.truncate() / value.w, value.w * surface.front, value.w * surface.back)
    }

    fn child(&self, volumes: &Volumes, place: UVec3, level: u32) -> Cell {
        if level == 1 && self.isotropic_base {
            return Self::voxel(volumes, place, volumes.level(0, 0).load(place));
        }
        self.cell(|volume, block| volumes.load_block(volume, level - 1, place, block))
    }

    /// The largest share of band 1 with which nothing is negative in any direction.
    fn window(&self, band0: DVec3, size1: DVec3) -> DVec3 {
        if !self.windowed {
            return DVec3::ONE;
        }
        (band0 / size1.max(DVec3::splat(1e-20))).clamp(DVec3::ZERO, DVec3::ONE)
    }

    fn bands_against(&self, cell: &Cell, direction: DVec3) -> DVec3 {
        let size1 = cell.band1.iter().map(|more| more * more).sum::<DVec3>().map(f64::sqrt);
        cell.bands_towards(-direction, self.window(cell.band0, 0.75 * size1)).max(DVec3::ZERO)
    }

    fn radiance_by_bands(&self, cell: &Cell, direction: DVec3) -> DVec3 {
        let one = Cell::emitter(DVec3::ONE, cell.positive, cell.negative);
        self.bands_against(cell, direction)
            / self.bands_against(&one, direction).x.max(0.35 * one.band0.x + 1e-6)
    }

    fn sample_cell(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let cell = self.cell_at(volumes, uvw, level);
        let towards = DVec3::select(direction.cmpgt(DVec3::ZERO), cell.negative, cell.positive);
        let opacity = direction.abs().dot(towards).min(1.0);
        (self.radiance_by_bands(&cell, direction) * opacity).extend(opacity)
    }
}

impl Twin for Sh2Twin {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, _: DVec3, opacity: f64) {
        let value = (radiance * opacity).extend(opacity);
        if self.isotropic_base {
            volumes.level_mut(0, 0).store(cell, value);
            return;
        }
        let voxel = Self::voxel(volumes, cell, value);
        self.store(volumes, cell, 0, &voxel);
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        let child = children(cell).map(|child| self.child(volumes, child, level));
        let offsets = children(UVec3::ZERO).map(|offset| 1.0 - 2.0 * offset.as_dvec3());
        let sent: [Cell; 8] =
            std::array::from_fn(
                |i| if self.projected { project_child(child[i], offsets[i]) } else { child[i] },
            );
        let positive = composite_coverage(&child.map(|child| child.positive));
        let negative = composite_coverage(&child.map(|child| child.negative));
        let weight: f64 = child.iter().map(Cell::sides_opacity).sum();
        let scale = (positive + negative).element_sum() / weight.max(1e-6);
        let parent = Cell {
            band0: sent.iter().map(|sent| sent.band0).sum::<DVec3>() * scale,
            band1: std::array::from_fn(|axis| {
                sent.iter().map(|sent| sent.band1[axis]).sum::<DVec3>() * scale
            }),
            positive,
            negative,
        };
        self.store(volumes, cell, level, &parent);
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        if !self.isotropic_base {
            return self.sample_cell(volumes, uvw, level, direction);
        }
        let coarse = self.sample_cell(volumes, uvw, (level - 1.0).max(0.0), direction);
        volumes.sample_over_base(0, uvw, level, coarse)
    }
}
