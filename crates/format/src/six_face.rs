//! `six_face`: one value for each side from which a voxel is seen (RAU §5.1.2, DVS §1.1 and §3).
//!
//! Level 0 is isotropic and shared; from level 1 up each of six faces composites the nearer child over the
//! farther and averages the four columns. Per voxel of the grid at `rgba16float`: 8 bytes and 6/7 of 8 more. With
//! any other `base` the faces begin at level 0: 48 bytes and 1/7 of 48 more.

use crate::{Choices, FormatOption, StorageFormat, Volume};

/// See the module.
#[derive(Clone, Copy, Debug)]
pub struct SixFace;

const BASE: FormatOption = FormatOption {
    name: "base",
    summary: "level 0: one value for all faces (isotropic), all of it on the face that the normal is nearest to \
              (dominant), on the three faces that the normal points to by the squares of its components (weighted), or by \
              their cosines (cosine)",
    words: &["isotropic", "dominant", "weighted", "cosine"],
};

const EMPTY: FormatOption = FormatOption {
    name: "empty",
    summary: "faces of a directional level 0 that the normal gives nothing: transparent (clear), opaque without \
              light (black), or as the voxel's value (fill)",
    words: &["clear", "black", "fill"],
};

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

    fn options(&self) -> &[FormatOption] {
        &[BASE, EMPTY]
    }

    fn volumes(&self, choices: &Choices) -> Vec<Volume> {
        Volume::directional("faces", 6, false, choices.word(&BASE) == "isotropic")
    }
}
