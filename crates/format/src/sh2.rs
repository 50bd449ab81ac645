//! `sh2`: two bands of spherical harmonics (RAU §5.1.3).
//!
//! Level 0 is isotropic; level 1 turns each voxel into the lobe of a one-sided Lambertian emitter about its
//! normal, and coarser levels average the coefficients, which is exact. Opacity is the same for all directions.
//! Per voxel of the grid at `rgba16float`: 8 bytes and 4/7 of 8 more.

use crate::{Levels, StorageFormat, Volume};

/// See the module.
#[derive(Clone, Copy, Debug)]
pub struct Sh2;

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

    fn volumes(&self) -> &[Volume] {
        &[
            Volume { name: "base", levels: Levels::Finest, blocks: 1 },
            Volume { name: "harmonics", levels: Levels::Coarser, blocks: 4 },
        ]
    }
}
