//! `sh2`: two bands of spherical harmonics (RAU §5.1.3).
//!
//! Level 0 is isotropic; level 1 turns each voxel into the lobe of a one-sided Lambertian emitter about its
//! normal, and coarser levels average the coefficients, which is exact. Opacity is kept for each of six sides.
//! Per voxel of the grid at `rgba16float`: 8 bytes and 4/7 of 8 more. With `base=lobe` the coefficients begin at
//! level 0: 32 bytes and 1/7 of 32 more.

use crate::{Choices, FormatOption, StorageFormat, Volume};

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
}
