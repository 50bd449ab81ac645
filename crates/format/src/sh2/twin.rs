//! `wgsl/format/sh2`.

use glam::{DMat3, DVec3, DVec4, UVec3};

use crate::twin::{Twin, Volumes, children};

/// How a parent is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mip {
    Composited,
    Linear,
    Projected,
}

/// How radiance is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Negatives {
    Sides,
    Clamp,
    Window,
}

/// See the module.
pub(super) struct Sh2Twin {
    pub(super) isotropic_base: bool,
    pub(super) mip: Mip,
    pub(super) negatives: Negatives,
}

/// What an observer sees along x, y and z: premultiplied radiance and opacity.
type Seen = [DVec4; 3];

/// Half the sum of what the six sides show, by how much the positive side of each axis shows more, and opacities.
#[derive(Clone, Copy, Default)]
struct Cell {
    band0: DVec3,
    band1: [DVec3; 3],
    positive: DVec3,
    negative: DVec3,
}

impl Cell {
    fn encode(positive: &Seen, negative: &Seen) -> Cell {
        let opacity = |seen: &Seen| DVec3::new(seen[0].w, seen[1].w, seen[2].w);
        Cell {
            band0: 0.5 * (0..3).map(|axis| (positive[axis] + negative[axis]).truncate()).sum::<DVec3>(),
            band1: std::array::from_fn(|axis| (positive[axis] - negative[axis]).truncate()),
            positive: opacity(positive),
            negative: opacity(negative),
        }
    }

    /// What both sides of the axes show in all.
    fn shared_in_all(&self) -> DVec3 {
        let more: DVec3 = self.band1.iter().map(|more| more.abs()).sum();
        (self.band0 - 0.5 * more).max(DVec3::ZERO)
    }

    /// The share of it that each axis is taken to have.
    fn share_of_axes(&self) -> DVec3 {
        let both = self.positive.min(self.negative);
        both / both.element_sum().max(1e-6)
    }

    /// Along one axis, of an observer who looks along the axes in these directions, 1 or −1.
    fn seen_along(&self, axis: usize, ahead: DVec3, of_both: DVec3) -> DVec4 {
        let side = if ahead[axis] > 0.0 { self.negative } else { self.positive };
        (of_both + (-ahead[axis] * self.band1[axis]).max(DVec3::ZERO)).extend(side[axis])
    }

    fn seen_from(&self, ahead: DVec3) -> Seen {
        let (all, share) = (self.shared_in_all(), self.share_of_axes());
        std::array::from_fn(|axis| self.seen_along(axis, ahead, all * share[axis]))
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

/// What the children show to an observer on the side of those with a 1 in `near`, or of the others.
fn composite(seen: &[Seen; 8], near: bool) -> Seen {
    std::array::from_fn(|axis| {
        let along = 1 << axis;
        let column = |low: usize| {
            let (first, last) = if near { (low | along, low) } else { (low, low | along) };
            let (first, last) = (seen[first][axis], seen[last][axis]);
            first + (1.0 - first.w) * last
        };
        (0..8).filter(|i| i & along == 0).map(column).sum::<DVec4>() / 4.0
    })
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
        let [front, back] =
            [surface.front, surface.back].map(|side| std::array::from_fn(|axis| value * side[axis]));
        Cell::encode(&front, &back)
    }

    fn child(&self, volumes: &Volumes, place: UVec3, level: u32) -> Cell {
        if level == 1 && self.isotropic_base {
            return Self::voxel(volumes, place, volumes.level(0, 0).load(place));
        }
        self.cell(|volume, block| volumes.load_block(volume, level - 1, place, block))
    }

    /// The largest share of band 1 with which nothing is negative in any direction.
    fn window(&self, band0: DVec3, size1: DVec3) -> DVec3 {
        match self.negatives {
            Negatives::Window => (band0 / size1.max(DVec3::splat(1e-20))).clamp(DVec3::ZERO, DVec3::ONE),
            _ => DVec3::ONE,
        }
    }

    fn bands_against(&self, cell: &Cell, direction: DVec3) -> DVec3 {
        let size1 = cell.band1.iter().map(|more| more * more).sum::<DVec3>().map(f64::sqrt);
        cell.bands_towards(-direction, self.window(cell.band0, 0.75 * size1)).max(DVec3::ZERO)
    }

    fn radiance_by_bands(&self, cell: &Cell, direction: DVec3) -> DVec3 {
        let half_sum = 0.5 * cell.sides_opacity();
        let more = (cell.positive - cell.negative).to_array();
        let one = Cell { band0: DVec3::splat(half_sum), band1: more.map(DVec3::splat), ..*cell };
        self.bands_against(cell, direction)
            / self.bands_against(&one, direction).x.max(0.35 * half_sum + 1e-6)
    }

    fn sample_sides(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let cell = self.cell_at(volumes, uvw, level);
        let seen = cell.seen_from(direction.map(|d| if d > 0.0 { 1.0 } else { -1.0 }));
        let value: DVec4 = (0..3).map(|axis| direction[axis].abs() * seen[axis]).sum();
        if self.negatives == Negatives::Sides {
            return value / value.w.max(1.0);
        }
        let opacity = value.w.min(1.0);
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
        let seen = |ahead: f64| child.map(|c| c.seen_from(DVec3::splat(ahead)));
        let mut parent = Cell::encode(&composite(&seen(-1.0), true), &composite(&seen(1.0), false));
        if self.mip != Mip::Composited {
            let offsets = children(UVec3::ZERO).map(|offset| 1.0 - 2.0 * offset.as_dvec3());
            let sent: [Cell; 8] = std::array::from_fn(|i| match self.mip {
                Mip::Projected => project_child(child[i], offsets[i]),
                _ => child[i],
            });
            let weight: f64 = child.iter().map(Cell::sides_opacity).sum();
            let scale = parent.sides_opacity() / weight.max(1e-6);
            parent.band0 = sent.iter().map(|sent| sent.band0).sum::<DVec3>() * scale;
            parent.band1 =
                std::array::from_fn(|axis| sent.iter().map(|sent| sent.band1[axis]).sum::<DVec3>() * scale);
        }
        self.store(volumes, cell, level, &parent);
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        if !self.isotropic_base {
            return self.sample_sides(volumes, uvw, level, direction);
        }
        let coarse = self.sample_sides(volumes, uvw, (level - 1.0).max(0.0), direction);
        volumes.sample_over_base(0, uvw, level, coarse)
    }
}
