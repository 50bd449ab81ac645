//! A format's volumes in memory.

use glam::{DVec3, DVec4, UVec3};

use super::VoxelSurface;
use crate::{Volume, level_count};

/// One mip level of a volume, x fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    /// Texels along x, y, z; blocks stand one above the other along z.
    pub size: UVec3,
    /// Their values.
    pub values: Vec<DVec4>,
}

impl Texels {
    fn index(&self, texel: UVec3) -> usize {
        ((texel.z * self.size.y + texel.y) * self.size.x + texel.x) as usize
    }

    /// The value at a texel inside.
    pub fn load(&self, texel: UVec3) -> DVec4 {
        self.values[self.index(texel)]
    }

    /// Sets the value at a texel inside.
    pub fn store(&mut self, texel: UVec3, value: DVec4) {
        let index = self.index(texel);
        self.values[index] = value;
    }

    /// Linear filtering, clamped at the borders.
    fn linear(&self, uvw: DVec3) -> DVec4 {
        let at = uvw * self.size.as_dvec3() - 0.5;
        let weight = at - at.floor();
        let last = (self.size - 1).as_dvec3();
        let corner = |i: u32| {
            let offset = UVec3::new(i & 1, i >> 1 & 1, i >> 2).as_dvec3();
            let share = offset * weight + (1.0 - offset) * (1.0 - weight);
            let texel = (at.floor() + offset).clamp(DVec3::ZERO, last).as_uvec3();
            (share.element_product(), texel)
        };
        // What counts for nothing isn't read, so that 0 · ∞ is no matter.
        (0..8)
            .map(corner)
            .filter(|(share, _)| *share > 0.0)
            .map(|(share, texel)| share * self.load(texel))
            .sum()
    }
}

/// All volumes of a format, and what the voxels of the grid are.
#[derive(Clone, Debug)]
pub struct Volumes {
    /// Voxels along each side of the grid.
    pub side: u32,
    /// The format's volumes with their mip levels.
    pub volumes: Vec<(Volume, Vec<Texels>)>,
    /// Each voxel's surface, x fastest; `None` where none is.
    pub surfaces: Vec<Option<VoxelSurface>>,
}

impl Volumes {
    /// Volumes of zeroes for a grid without voxels.
    pub fn new(volumes: &[Volume], side: u32) -> Volumes {
        let grid = [side; 3];
        let empty = |volume: &Volume, mip: u32| {
            let size = UVec3::from_array(volume.size(grid).map(|n| (n >> mip).max(1)));
            Texels { size, values: vec![DVec4::ZERO; size.element_product() as usize] }
        };
        let mips = |volume: &Volume| (0..volume.mip_levels(grid)).map(|mip| empty(volume, mip)).collect();
        Volumes {
            side,
            volumes: volumes.iter().map(|volume| (*volume, mips(volume))).collect(),
            surfaces: vec![None; (side * side * side) as usize],
        }
    }

    /// Levels of the grid.
    pub fn levels(&self) -> u32 {
        level_count([self.side; 3])
    }

    /// The surface of a voxel.
    pub fn surface(&self, cell: UVec3) -> Option<VoxelSurface> {
        self.surfaces[((cell.z * self.side + cell.y) * self.side + cell.x) as usize]
    }

    /// The texels of a volume at a level of the grid that it holds.
    pub fn level(&self, volume: usize, level: u32) -> &Texels {
        let (volume, mips) = &self.volumes[volume];
        &mips[(level - volume.first_level()) as usize]
    }

    /// As [`Volumes::level`].
    pub fn level_mut(&mut self, volume: usize, level: u32) -> &mut Texels {
        let (volume, mips) = &mut self.volumes[volume];
        &mut mips[(level - volume.first_level()) as usize]
    }

    /// A cell's value in a block of a volume that holds this level of the grid.
    pub fn load_block(&self, volume: usize, level: u32, cell: UVec3, block: u32) -> DVec4 {
        let texels = self.level(volume, level);
        texels.load(cell + UVec3::Z * (block * texels.size.z / self.volumes[volume].0.blocks))
    }

    /// Sets what [`Volumes::load_block`] gives.
    pub fn store_block(&mut self, volume: usize, level: u32, cell: UVec3, block: u32, value: DVec4) {
        let blocks = self.volumes[volume].0.blocks;
        let texels = self.level_mut(volume, level);
        let depth = texels.size.z / blocks;
        texels.store(cell + UVec3::Z * (block * depth), value);
    }

    /// `sample_block` of `wgsl/common/volume.wgsl`: never mixes two blocks.
    pub fn sample_block(&self, volume: usize, block: u32, uvw: DVec3, mip: f64) -> DVec4 {
        let (of, mips) = &self.volumes[volume];
        let half_texel = 0.5 * mip.ceil().exp2() * f64::from(of.blocks) / f64::from(mips[0].size.z);
        let w = uvw.z.clamp(half_texel, 1.0 - half_texel);
        self.sample(volume, uvw.with_z((f64::from(block) + w) / f64::from(of.blocks)), mip)
    }

    /// `sample_over_base` of `wgsl/common/isotropic_base.wgsl`: level 0 as far as level 1, `coarse`, shows it;
    /// from level 1 up, `coarse`.
    pub fn sample_over_base(&self, base: usize, uvw: DVec3, level: f64, coarse: DVec4) -> DVec4 {
        const FACING_FULL: f64 = 0.25;
        if level >= 1.0 {
            return coarse;
        }
        let fine = self.sample(base, uvw, 0.0) * (coarse.w / FACING_FULL).clamp(0.0, 1.0);
        fine.lerp(coarse, level.max(0.0))
    }

    /// Linear in space and between mip levels, both clamped: `textureSampleLevel`.
    pub fn sample(&self, volume: usize, uvw: DVec3, mip: f64) -> DVec4 {
        let mips = &self.volumes[volume].1;
        let mip = mip.clamp(0.0, (mips.len() - 1) as f64);
        let fine = mips[mip.floor() as usize].linear(uvw);
        if mip.fract() == 0.0 { fine } else { fine.lerp(mips[mip.ceil() as usize].linear(uvw), mip.fract()) }
    }
}
