//! `sh2`: two bands of spherical harmonics (RAU §5.1.3).
//!
//! Level 0 is isotropic; from level 1 up a cell's surfaces stand as facets that look along the axes, each with the
//! coefficients of a one-sided Lambertian emitter. Opacity is kept for each of six sides, in bytes.
//! Per voxel of the grid at `rgba16float`: 8 bytes and 4/7 of 8 more. With `base=lobe` the coefficients begin at
//! level 0: 32 bytes and 1/7 of 32 more.

mod twin;

use self::twin::{Mip, Negatives, Sh2Twin};
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
    summary: "a parent: what its sides show, nearer children over farther (composited), its children's mean \
              (linear), or what they send through its six faces (projected, RAU eq. 5.9 over π, which shrinks band 1 \
              to 2/3 at each level)",
    words: &["composited", "linear", "projected"],
};

const NEGATIVES: FormatOption = FormatOption {
    name: "negatives",
    summary: "radiance from a direction: what the sides towards it show (sides), or the sum of the bands, which may \
              be below zero: cut off (clamp), or avoided by less of band 1 (window)",
    words: &["sides", "clamp", "window"],
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
                property: Property::Linear,
                at: "",
                size: 0.021,
                why: "what both sides of three axes show is shared out by their opacity",
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
        Some(Box::new(Sh2Twin {
            isotropic_base: choices.word(&BASE) == "isotropic",
            mip: match choices.word(&MIP) {
                "linear" => Mip::Linear,
                "projected" => Mip::Projected,
                _ => Mip::Composited,
            },
            negatives: match choices.word(&NEGATIVES) {
                "clamp" => Negatives::Clamp,
                "window" => Negatives::Window,
                _ => Negatives::Sides,
            },
        }))
    }
}
