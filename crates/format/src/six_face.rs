//! `six_face`: one value for each side from which a voxel is seen (RAU §5.1.2, DVS §1.1 and §3).
//!
//! Level 0 is isotropic and shared; from level 1 up each of six faces composites the nearer child over the
//! farther and averages the four columns. Per voxel of the grid at `rgba16float`: 8 bytes and 6/7 of 8 more.

use crate::{Levels, StorageFormat, Volume};

/// See the module.
#[derive(Clone, Copy, Debug)]
pub struct SixFace;

impl StorageFormat for SixFace {
    fn name(&self) -> &str {
        "six_face"
    }

    fn summary(&self) -> &str {
        "a radiance and opacity for each of six directions, from level 1 up"
    }

    fn modules(&self) -> &str {
        "format/six_face"
    }

    fn volumes(&self) -> &[Volume] {
        &[
            Volume { name: "base", levels: Levels::Finest, blocks: 1 },
            Volume { name: "faces", levels: Levels::Coarser, blocks: 6 },
        ]
    }
}
