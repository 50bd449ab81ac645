//! `sh2`: two bands of spherical harmonics (RAU §5.1.3).
//!
//! Level 0 is isotropic; level 1 turns each voxel into the lobe of a one-sided Lambertian emitter about its
//! normal, and coarser levels average the coefficients, which is exact. Opacity is kept for each of six sides.
//! Per voxel of the grid at `rgba16float`: 8 bytes and 4/7 of 8 more. With `base=lobe` the coefficients begin at
//! level 0: 32 bytes and 1/7 of 32 more.

use std::f64::consts::PI;

use glam::{DVec3, DVec4, UVec3, Vec4Swizzles};

use crate::twin::{Twin, Volumes, children, composite_coverage};
use crate::{Choices, FormatOption, Miss, Property, StorageFormat, Volume};

/// See the module.
#[derive(Clone, Copy, Debug)]
pub struct Sh2;

const BASE: FormatOption = FormatOption {
    name: "base",
    summary: "level 0: one value for all directions (isotropic), or the coefficients of a one-sided emitter (lobe)",
    words: &["isotropic", "lobe"],
};

const MIP: FormatOption = FormatOption {
    name: "mip",
    summary: "a parent: its children's mean (linear), or what they send through its six faces (projected, RAU eq. \
              5.9 over π, which shrinks band 1 to 2/3 at each level)",
    words: &["linear", "projected"],
};

const NEGATIVES: FormatOption = FormatOption {
    name: "negatives",
    summary: "radiance below zero: cut off (clamp), or avoided by less of band 1 (window)",
    words: &["clamp", "window"],
};

impl StorageFormat for Sh2 {
    fn name(&self) -> &str {
        "sh2"
    }

    fn summary(&self) -> &str {
        "four spherical-harmonic coefficients of radiance, from level 1 up"
    }

    fn modules(&self) -> &str {
        "format/sh2"
    }

    fn options(&self) -> &[FormatOption] {
        &[BASE, MIP, NEGATIVES]
    }

    fn volumes(&self, choices: &Choices) -> Vec<Volume> {
        Volume::directional("harmonics", 4, true, choices.word(&BASE) == "isotropic")
    }

    fn misses(&self) -> &[Miss] {
        &[
            Miss {
                property: Property::Energy,
                at: "wall, level 0",
                size: 0.65,
                why: "level 0 is as opaque at a slant as head-on; from level 1 up a face is seen at the cosine",
            },
            Miss {
                property: Property::Energy,
                at: "haze, level 0",
                size: 0.52,
                why: "level 0 is seen only as far as level 1 covers a quarter",
            },
            Miss {
                property: Property::Energy,
                at: "haze",
                size: 0.36,
                why: "what both sides of any axis cover counts for all axes",
            },
            Miss {
                property: Property::Sides,
                at: "",
                size: 0.25,
                why: "two bands of two opposite lobes overshoot to 1.25 ahead",
            },
            Miss {
                property: Property::Ahead,
                at: "",
                size: 0.5,
                why: "sides of three axes share four numbers, so what lies behind can't be left out",
            },
            Miss {
                property: Property::Linear,
                at: "",
                size: 0.025,
                why: "negative radiance behind a lobe is clamped, colour by colour",
            },
        ]
    }

    fn twin(&self, choices: &Choices) -> Option<Box<dyn Twin>> {
        let [base, mip, negatives] = [&BASE, &MIP, &NEGATIVES].map(|option| choices.word(option));
        Some(Box::new(Sh2Twin {
            isotropic_base: base == "isotropic",
            projected: mip == "projected",
            windowed: negatives == "window",
        }))
    }
}

/// `wgsl/format/sh2`.
struct Sh2Twin {
    isotropic_base: bool,
    projected: bool,
    windowed: bool,
}

const COEFFICIENTS: u32 = 4;

/// Values of the two bands' functions, and the coefficients of a one-sided Lambertian emitter of radiance 1.
struct Bands {
    sh0: f64,
    sh1: f64,
    lobe0: f64,
    lobe1: f64,
}

fn bands() -> Bands {
    Bands {
        sh0: 1.0 / (2.0 * PI.sqrt()),
        sh1: 3f64.sqrt() / (2.0 * PI.sqrt()),
        lobe0: PI.sqrt(),
        lobe1: (3.0 * PI).sqrt() / 2.0,
    }
}

/// Opacities seen from +x, +y, +z and from −x, −y, −z, as alpha of the four coefficients.
fn encode_opacity(positive: DVec3, negative: DVec3) -> DVec4 {
    let more = positive - negative;
    DVec4::new(positive.min(negative).max_element(), more.x, more.y, more.z)
}

fn decode_opacity(alpha: DVec4) -> (DVec3, DVec3) {
    let side = |more: DVec3| (alpha.x + more.max(DVec3::ZERO)).clamp(DVec3::ZERO, DVec3::ONE);
    (side(alpha.yzw()), side(-alpha.yzw()))
}

fn mean_opacity(alpha: DVec4) -> f64 {
    alpha.x + alpha.yzw().abs().element_sum() / 6.0
}

/// Of a voxel of level 0 with this premultiplied radiance and opacity.
fn voxel_lobe(volumes: &Volumes, cell: UVec3, value: DVec4) -> [DVec4; 4] {
    let Some(surface) = volumes.surface(cell).filter(|_| value.w > 0.0) else { return [DVec4::ZERO; 4] };
    let alpha = encode_opacity(surface.front, surface.back);
    let radiance = value.truncate() * mean_opacity(alpha);
    let (lobe, n) = (bands(), surface.normal);
    let shares = [lobe.lobe0, lobe.lobe1 * n.x, lobe.lobe1 * n.y, lobe.lobe1 * n.z];
    std::array::from_fn(|k| (radiance * shares[k]).extend(alpha[k]))
}

/// RAU eq. 5.9 over π: what a child sends through its parent's six faces. `inwards` is 1 or −1 along each axis.
fn project_child(c: &[DVec4; 4], inwards: DVec3) -> [DVec3; 4] {
    const FAR_FACE: f64 = 1.0747930;
    const NEAR_FACE: f64 = 3.1139972;
    let Bands { sh0, sh1, .. } = bands();
    let (cosine0, cosine1) = (PI.sqrt() / 2.0, (PI / 3.0).sqrt());
    let [c0, cx, cy, cz] = c.map(DVec4::truncate);
    let mut projected = [DVec3::ZERO; 4];
    for face in 0..6 {
        let mut centre = inwards;
        centre[face / 2] += if face % 2 == 1 { -2.0 } else { 2.0 };
        let solid_angle = if centre[face / 2].abs() > 2.0 { FAR_FACE } else { NEAR_FACE };
        let d = centre.normalize();
        let share = (sh0 * c0 + sh1 * (d.x * cx + d.y * cy + d.z * cz)) * (solid_angle / PI);
        projected[0] += share * cosine0;
        (0..3).for_each(|axis| projected[axis + 1] += share * (cosine1 * d[axis]));
    }
    projected
}

impl Sh2Twin {
    /// The volume of the coefficients; `base`, where it is, comes first.
    fn harmonics(&self) -> usize {
        usize::from(self.isotropic_base)
    }

    fn child(&self, volumes: &Volumes, cell: UVec3, level: u32) -> [DVec4; 4] {
        if level == 1 && self.isotropic_base {
            return voxel_lobe(volumes, cell, volumes.level(0, 0).load(cell));
        }
        std::array::from_fn(|k| volumes.load_block(self.harmonics(), level - 1, cell, k as u32))
    }

    /// The largest share of band 1 with which nothing is negative in any direction.
    fn window(&self, band0: DVec3, size1: DVec3) -> DVec3 {
        if !self.windowed {
            return DVec3::ONE;
        }
        (band0 / size1.max(DVec3::splat(1e-20))).clamp(DVec3::ZERO, DVec3::ONE)
    }

    fn sample_harmonics(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let c: [DVec4; 4] =
            std::array::from_fn(|k| volumes.sample_block(self.harmonics(), k as u32, uvw, level));
        let alpha = DVec4::from_array(c.map(|c| c.w));
        let (positive, negative) = decode_opacity(alpha);
        let facing = DVec3::select(direction.cmpgt(DVec3::ZERO), negative, positive);
        let opacity = direction.abs().dot(facing).min(1.0);
        let Bands { sh0, sh1, lobe0, lobe1 } = bands();
        let [c0, cx, cy, cz] = c.map(DVec4::truncate);
        let band0 = sh0 * c0;
        let band1 = sh1 * (direction.x * cx + direction.y * cy + direction.z * cz);
        let size1 = sh1 * (cx * cx + cy * cy + cz * cz).map(f64::sqrt);
        let radiance = band0 - self.window(band0, size1) * band1;
        let more = alpha.yzw();
        let lobe = more.abs().element_sum() / 6.0;
        let mean = mean_opacity(alpha);
        let (unit0, unit1) = (sh0 * lobe0 * mean, sh1 * lobe1 * lobe);
        let window = self.window(DVec3::splat(unit0), DVec3::splat(unit1)).x;
        let unit = unit0 - window * unit1 * direction.dot(more) / more.length().max(1e-6);
        (radiance.max(DVec3::ZERO) / unit.max(0.35 * mean + 1e-6) * opacity).extend(opacity)
    }
}

impl Twin for Sh2Twin {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, _: DVec3, opacity: f64) {
        let value = (radiance * opacity).extend(opacity);
        if self.isotropic_base {
            volumes.level_mut(0, 0).store(cell, value);
            return;
        }
        let c = voxel_lobe(volumes, cell, value);
        (0..COEFFICIENTS).for_each(|k| volumes.store_block(self.harmonics(), 0, cell, k, c[k as usize]));
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        let child = children(cell).map(|child| self.child(volumes, child, level));
        let alphas = child.map(|c| DVec4::from_array(c.map(|c| c.w)));
        let six = alphas.map(decode_opacity);
        let weight: f64 = alphas.into_iter().map(mean_opacity).sum();
        let alpha = encode_opacity(
            composite_coverage(&six.map(|six| six.0)),
            composite_coverage(&six.map(|six| six.1)),
        );
        let scale = mean_opacity(alpha) / weight.max(1e-6);
        let offsets = children(UVec3::ZERO);
        let sent: [[DVec3; 4]; 8] = std::array::from_fn(|i| match self.projected {
            true => project_child(&child[i], 1.0 - 2.0 * offsets[i].as_dvec3()),
            false => child[i].map(DVec4::truncate),
        });
        for k in 0..COEFFICIENTS as usize {
            let sum: DVec3 = sent.iter().map(|sent| sent[k]).sum();
            volumes.store_block(self.harmonics(), level, cell, k as u32, (sum * scale).extend(alpha[k]));
        }
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        if !self.isotropic_base {
            return self.sample_harmonics(volumes, uvw, level, direction);
        }
        let coarse = self.sample_harmonics(volumes, uvw, (level - 1.0).max(0.0), direction);
        if level >= 1.0 { coarse } else { volumes.sample_over_base(0, uvw, level, coarse) }
    }
}
