//! Formats worked out on the CPU in `f64`, to hold the WGSL against.

mod coverage;
mod reflectance;
mod surface;
mod volumes;

pub use coverage::{composite_columns, composite_coverage};
pub use reflectance::total_reflectance;
pub use surface::{ATTRIBUTE_WORDS, VoxelSurface};
pub use volumes::{Texels, Volumes};

use glam::{DVec3, DVec4, UVec3};

/// A format's functions as its WGSL has them, on volumes in memory.
pub trait Twin: Send + Sync {
    /// Writes a voxel into level 0.
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, normal: DVec3, opacity: f64);

    /// Makes a cell of `level` from its eight children.
    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32);

    /// Premultiplied radiance that comes back along a ray of this unit direction of travel, and opacity.
    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4;
}

/// The children of a cell: child i lies at (i & 1, i >> 1 & 1, i >> 2).
pub fn children(cell: UVec3) -> [UVec3; 8] {
    std::array::from_fn(|i| cell * 2 + UVec3::new(i as u32 & 1, i as u32 >> 1 & 1, i as u32 >> 2))
}
