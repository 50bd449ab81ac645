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
                property: Property::Linear,
                at: "",
                size: 0.025,
                why: "negative radiance behind a lobe is clamped, colour by colour",
            },
        ]
    }

    fn twin(&self) -> Option<&dyn Twin> {
        Some(self)
    }
}

const BASE_VOLUME: usize = 0;
const HARMONICS: usize = 1;
const COEFFICIENTS: u32 = 4;
/// From this coverage by level 1 on, level 0 counts in full.
const FACING_FULL: f64 = 0.25;

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

fn child_of_base(volumes: &Volumes, cell: UVec3) -> [DVec4; 4] {
    let value = volumes.level(BASE_VOLUME, 0).load(cell);
    let Some(surface) = volumes.surface(cell).filter(|_| value.w > 0.0) else { return [DVec4::ZERO; 4] };
    let alpha = encode_opacity(surface.front, surface.back);
    let radiance = value.truncate() * mean_opacity(alpha);
    let (lobe, n) = (bands(), surface.normal);
    let shares = [lobe.lobe0, lobe.lobe1 * n.x, lobe.lobe1 * n.y, lobe.lobe1 * n.z];
    std::array::from_fn(|k| (radiance * shares[k]).extend(alpha[k]))
}

fn child_of_harmonics(volumes: &Volumes, cell: UVec3, level: u32) -> [DVec4; 4] {
    let harmonics = volumes.level(HARMONICS, level);
    std::array::from_fn(|k| harmonics.load(cell + UVec3::Z * (k as u32 * harmonics.size.z / COEFFICIENTS)))
}

fn sample_harmonics(volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
    let half_texel = 0.5 * level.ceil().exp2() / f64::from(volumes.side >> 1);
    let w = uvw.z.clamp(half_texel, 1.0 - half_texel);
    let c: [DVec4; 4] = std::array::from_fn(|k| {
        volumes.sample(HARMONICS, uvw.with_z((k as f64 + w) / f64::from(COEFFICIENTS)), level)
    });
    let alpha = DVec4::new(c[0].w, c[1].w, c[2].w, c[3].w);
    let (positive, negative) = decode_opacity(alpha);
    let facing = DVec3::select(direction.cmpgt(DVec3::ZERO), negative, positive);
    let opacity = direction.abs().dot(facing).min(1.0);
    let Bands { sh0, sh1, lobe0, lobe1 } = bands();
    let [c0, cx, cy, cz] = c.map(DVec4::truncate);
    let radiance = sh0 * c0 - sh1 * (direction.x * cx + direction.y * cy + direction.z * cz);
    let more = alpha.yzw();
    let lobe = more.abs().element_sum() / 6.0;
    let mean = mean_opacity(alpha);
    let unit = sh0 * lobe0 * mean - sh1 * lobe1 * lobe * direction.dot(more) / more.length().max(1e-6);
    (radiance.max(DVec3::ZERO) / unit.max(0.35 * mean + 1e-6) * opacity).extend(opacity)
}

impl Twin for Sh2 {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, _: DVec3, opacity: f64) {
        volumes.level_mut(BASE_VOLUME, 0).store(cell, (radiance * opacity).extend(opacity));
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        let child = children(cell).map(|child| match level {
            1 => child_of_base(volumes, child),
            _ => child_of_harmonics(volumes, child, level - 1),
        });
        let alphas = child.map(|c| DVec4::from_array(c.map(|c| c.w)));
        let six = alphas.map(decode_opacity);
        let weight: f64 = alphas.into_iter().map(mean_opacity).sum();
        let alpha = encode_opacity(
            composite_coverage(&six.map(|six| six.0)),
            composite_coverage(&six.map(|six| six.1)),
        );
        let scale = mean_opacity(alpha) / weight.max(1e-6);
        let harmonics = volumes.level_mut(HARMONICS, level);
        for k in 0..COEFFICIENTS as usize {
            let sum: DVec3 = child.iter().map(|c| c[k].truncate()).sum();
            let block = UVec3::Z * (k as u32 * harmonics.size.z / COEFFICIENTS);
            harmonics.store(cell + block, (sum * scale).extend(alpha[k]));
        }
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let coarse = sample_harmonics(volumes, uvw, (level - 1.0).max(0.0), direction);
        if level >= 1.0 {
            return coarse;
        }
        let fine = volumes.sample(BASE_VOLUME, uvw, 0.0) * (coarse.w / FACING_FULL).clamp(0.0, 1.0);
        fine.lerp(coarse, level.max(0.0))
    }
}
