//! `wgsl/common/attributes.wgsl`, as far as formats read it.

use glam::DVec3;

/// Words of a voxel's attributes without emission.
pub const ATTRIBUTE_WORDS: usize = 11;

/// What of a voxel's attributes formats read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VoxelSurface {
    /// Unit mean normal; zero where opposite surfaces cancel.
    pub normal: DVec3,
    /// Coverage seen by an observer at +x, +y, +z: `[0, 1]`.
    pub front: DVec3,
    /// Coverage seen by an observer at −x, −y, −z: `[0, 1]`.
    pub back: DVec3,
}

impl VoxelSurface {
    /// Decodes fixed-point sums: weight, weight of double-sided surfaces, reflectance, the normals' positive and
    /// negative parts.
    pub fn of(words: &[u32; ATTRIBUTE_WORDS]) -> VoxelSurface {
        let word = |index: usize| f64::from(words[index]);
        let vector = |first: usize| DVec3::new(word(first), word(first + 1), word(first + 2));
        let per_weight = 1.0 / word(0).max(1.0);
        let double_sided = word(1) * per_weight;
        let (positive, negative) = (vector(5) * per_weight, vector(8) * per_weight);
        let sum = positive - negative;
        let size = sum.length();
        let both = positive + negative;
        let other = both * double_sided;
        let crossing = both.element_sum();
        let cover = |side: DVec3| (side.max(other) * crossing).clamp(DVec3::ZERO, DVec3::ONE);
        VoxelSurface {
            normal: if size > 0.1 { sum / size } else { DVec3::ZERO },
            front: cover(positive),
            back: cover(negative),
        }
    }
}
