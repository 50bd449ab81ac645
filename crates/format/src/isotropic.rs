//! `isotropic`: the same radiance in every direction (RAU §5.1.1).
//!
//! One RGBA texel a voxel on all levels; a parent is the mean of its children. 8 bytes a voxel at
//! `rgba16float`, 8/7 of that with its levels. A wall between two rooms shows each room the mean of both sides
//! (RAU figure 5.6).

use glam::{DVec3, DVec4, UVec3};

use crate::twin::{Twin, Volumes, children, composite_columns};
use crate::{Choices, Levels, Miss, Numbers, Property, StorageFormat, Volume};

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
        vec![Volume { name: "base", levels: Levels::All, blocks: 1, numbers: Numbers::Radiance }]
    }

    fn misses(&self) -> &[Miss] {
        &[Miss {
            property: Property::Sides,
            at: "",
            size: 0.5,
            why: "both sides of a wall share one radiance: red and green make yellow (RAU figure 5.6)",
        }]
    }

    fn twin(&self, _: &Choices) -> Option<Box<dyn Twin>> {
        Some(Box::new(*self))
    }
}

const BASE_VOLUME: usize = 0;

impl Twin for Isotropic {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, _: DVec3, opacity: f64) {
        volumes.level_mut(BASE_VOLUME, 0).store(cell, (radiance * opacity).extend(opacity));
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        let child = children(cell).map(|child| volumes.level(BASE_VOLUME, level - 1).load(child));
        let sum: DVec4 = child.iter().sum();
        let most = (0..3).map(|axis| composite_columns(&child, axis, 0).w).fold(0.0, f64::max);
        let radiance = sum.truncate() * (most / sum.w.max(1e-6));
        volumes.level_mut(BASE_VOLUME, level).store(cell, radiance.extend(most));
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, _: DVec3) -> DVec4 {
        volumes.sample(BASE_VOLUME, uvw, level)
    }
}
