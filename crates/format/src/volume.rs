//! The textures that a format keeps.

use crate::{Encoding, Texel};

/// Levels of a grid: down to the one where some side can't be halved exactly.
pub fn level_count(grid: [u32; 3]) -> u32 {
    grid.into_iter().map(|side| side.max(1).trailing_zeros()).min().unwrap_or(0) + 1
}

/// Which of the grid's levels a volume holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Levels {
    /// Level 0 alone.
    Finest,
    /// All levels.
    All,
    /// All but level 0.
    Coarser,
}

/// What the numbers of a volume's texels are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// Radiance and in alpha opacity, not below zero.
    Radiance,
    /// The same below zero too: coefficients.
    Signed,
    /// Four radiances, below zero too. In WGSL `encode_radiances` and `decode_radiances` stand for `encode_texel` and
    /// `decode_texel`.
    Radiances,
    /// Four shares of 1, each a byte whatever the encoding is.
    Coverage,
}

impl Numbers {
    /// What holds them.
    pub fn texel(self, encoding: Encoding) -> Texel {
        match self {
            Numbers::Radiance => encoding.texel,
            Numbers::Signed | Numbers::Radiances => encoding.signed_texel,
            Numbers::Coverage => Texel::Rgba8Unorm,
        }
    }

    /// The largest of each channel. Opacity in bytes is a share of 1.
    pub fn ranges(self, encoding: Encoding) -> [f32; 4] {
        let range = encoding.range;
        match (self, self.texel(encoding)) {
            (Numbers::Coverage, _) => [1.0; 4],
            (Numbers::Radiance | Numbers::Signed, Texel::Rgba8Unorm | Texel::Rgba8Snorm) => {
                [range, range, range, 1.0]
            }
            _ => [range; 4],
        }
    }
}

/// A 3D texture of a format. Blocks stand one above the other along z, one for each direction or coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Volume {
    /// Its name in WGSL.
    pub name: &'static str,
    /// The grid's levels that it holds.
    pub levels: Levels,
    /// Blocks along z.
    pub blocks: u32,
    /// What its texels hold.
    pub numbers: Numbers,
}

impl Volume {
    /// The volumes of a format whose blocks begin at level 1, over a level 0 called `base` that is the same from all
    /// sides, or else at level 0.
    pub fn directional(
        name: &'static str,
        blocks: u32,
        numbers: Numbers,
        isotropic_base: bool,
    ) -> Vec<Volume> {
        if isotropic_base {
            let base = Volume { name: "base", levels: Levels::Finest, blocks: 1, numbers: Numbers::Radiance };
            vec![base, Volume { name, levels: Levels::Coarser, blocks, numbers }]
        } else {
            vec![Volume { name, levels: Levels::All, blocks, numbers }]
        }
    }

    /// The grid's level that is the texture's mip level 0.
    pub fn first_level(&self) -> u32 {
        match self.levels {
            Levels::Finest | Levels::All => 0,
            Levels::Coarser => 1,
        }
    }

    /// Mip levels of the texture for a grid of this size in voxels.
    pub fn mip_levels(&self, grid: [u32; 3]) -> u32 {
        match self.levels {
            Levels::Finest => 1,
            Levels::All => level_count(grid),
            Levels::Coarser => (level_count(grid) - 1).max(1),
        }
    }

    /// Whether it holds this level of the grid.
    pub fn has_level(&self, level: u32, grid: [u32; 3]) -> bool {
        (self.first_level()..self.first_level() + self.mip_levels(grid)).contains(&level)
    }

    /// Texels of mip level 0.
    pub fn size(&self, grid: [u32; 3]) -> [u32; 3] {
        let [x, y, z] = grid.map(|n| (n >> self.first_level()).max(1));
        [x, y, z * self.blocks]
    }

    /// Bytes of all its levels.
    pub fn bytes(&self, grid: [u32; 3], encoding: Encoding) -> u64 {
        let texels: u64 = (0..self.mip_levels(grid))
            .map(|mip| self.size(grid).into_iter().map(|n| u64::from((n >> mip).max(1))).product::<u64>())
            .sum();
        texels * self.numbers.texel(encoding).bytes()
    }
}
