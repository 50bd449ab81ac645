//! `isotropic`: the same radiance in every direction (RAU §5.1.1).
//!
//! One RGBA texel a voxel on all levels; a parent is the mean of its children. 8 bytes a voxel at
//! `rgba16float`, 8/7 of that with its levels. A wall between two rooms shows each room the mean of both sides
//! (RAU figure 5.6).

use crate::{Choices, Levels, StorageFormat, Volume};

/// See the module.
#[derive(Clone, Copy, Debug)]
pub struct Isotropic;

impl StorageFormat for Isotropic {
    fn name(&self) -> &str {
        "isotropic"
    }

    fn summary(&self) -> &str {
        "one radiance and opacity for all directions"
    }

    fn modules(&self) -> &str {
        "format/isotropic"
    }

    fn volumes(&self, _: &Choices) -> Vec<Volume> {
        vec![Volume { name: "base", levels: Levels::All, blocks: 1, signed: false }]
    }
}
