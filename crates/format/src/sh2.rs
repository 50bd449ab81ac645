//! `sh2`: two bands of spherical harmonics (RAU §5.1.3).
//!
//! Level 0 is isotropic; level 1 turns each voxel into the lobe of a Lambertian emitter about its normal, and coarser levels
//! average the coefficients, which is exact. Opacity is kept for each of six sides, in bytes.
//! Per voxel of the grid at `rgba16float`: 8 bytes and 4/7 of 8 more. With `base=lobe` the coefficients begin at
//! level 0: 32 bytes and 1/7 of 32 more.

mod twin;

use self::twin::Sh2Twin;
use crate::twin::Twin;
use crate::{Choices, FormatOption, Miss, Numbers, Property, StorageFormat, Volume};

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
        let isotropic_base = choices.word(&BASE) == "isotropic";
        let mut volumes = Volume::directional("harmonics", 3, Numbers::Radiances, isotropic_base);
        let opacities =
            volumes.last().map(|v| Volume { name: "coverage", blocks: 2, numbers: Numbers::Coverage, ..*v });
        volumes.extend(opacities);
        volumes
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
                size: 0.97,
                why: "level 0 is seen only as far as level 1 covers a quarter",
            },
            Miss {
                property: Property::Sides,
                at: "",
                size: 0.25,
                why: "two bands of two opposite lobes overshoot to 1.25 ahead and −0.25 behind",
            },
            Miss {
                property: Property::Linear,
                at: "",
                size: 0.021,
                why: "what is below zero behind a lobe is cut off, colour by colour",
            },
            Miss {
                property: Property::Symmetric,
                at: "level 0",
                size: 0.025,
                why: "opacities are bytes, and level 0 is seen four times as far as level 1 covers",
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
