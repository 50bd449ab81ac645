//! The voxel grid and the layout of its bitmask.

use std::ops::RangeInclusive;

use glam::{DVec3, Vec3};
use voxlume_format::level_count;

/// A grid of cubic voxels. World positions inside are relative to its centre.
///
/// Sides are padded so that they halve exactly some times; the levels end where they no longer do.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Voxels along x, y, z.
    pub size: [u32; 3],
    /// World position of the grid's centre.
    pub centre: DVec3,
    /// Side of a voxel, world units.
    pub voxel_size: f32,
}

/// What space a grid takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// A cube around the scene.
    Cubic,
    /// A box around the scene.
    Bounds,
    /// The box between two corners, whatever of the scene lies in it.
    Box(DVec3, DVec3),
}

impl Grid {
    /// Voxels along the longest side, before padding.
    pub const RESOLUTIONS: RangeInclusive<u32> = 8..=512;

    /// [`Grid::RESOLUTIONS`] in words.
    pub fn resolution_range() -> String {
        format!("{} to {} along the longest side", Self::RESOLUTIONS.start(), Self::RESOLUTIONS.end())
    }

    /// A cube: see [`Grid::new`].
    pub fn fit(resolution: u32, bounds: Option<(DVec3, DVec3)>) -> Grid {
        Grid::new(resolution, Extent::Cubic, bounds)
    }

    /// A grid with `resolution` voxels along its longest side. Around a scene, that side spans all but three voxels, so
    /// that the outermost walls run through the middle of a voxel and one empty voxel remains around it.
    pub fn new(resolution: u32, extent: Extent, bounds: Option<(DVec3, DVec3)>) -> Grid {
        let scene = bounds.unwrap_or((DVec3::splat(-0.5), DVec3::splat(0.5)));
        let ((low, high), margin) = match extent {
            Extent::Box(low, high) => ((low, high), 0),
            Extent::Cubic | Extent::Bounds => (scene, 3),
        };
        let longest = (high - low).max_element();
        // A scene without extent still gets voxels of a size that f64 positions can tell apart.
        let least = (low.abs().max(high.abs()).max_element() * 1e-9).max(1e-30);
        let voxel_size = longest.max(least) / f64::from(resolution - margin);
        let needed = match extent {
            Extent::Cubic => [resolution; 3],
            Extent::Bounds | Extent::Box(..) => {
                // What rounding adds to a whole number of voxels is none of its own; what is thinner than a voxel still takes one.
                let voxels = ((high - low) / voxel_size - 1e-6).ceil().to_array();
                voxels.map(|n| (n as u32 + margin).clamp(1, resolution))
            }
        };
        let size = needed.map(|n| n.next_multiple_of(multiple(resolution)));
        // Padding by an odd number would move walls from the middle of voxels to their borders.
        let odd = DVec3::from_array([0, 1, 2].map(|i| f64::from((size[i] - needed[i]) % 2)));
        let centre = (low + high) / 2.0 + odd * (0.5 * voxel_size);
        Grid { size, centre, voxel_size: voxel_size as f32 }
    }

    /// Whether all of a scene lies in it, but for what rounding may take.
    pub fn holds(&self, (low, high): (DVec3, DVec3)) -> bool {
        let voxel = f64::from(self.voxel_size);
        let half = DVec3::from_array(self.size.map(|n| f64::from(n) * 0.5 * voxel)) * (1.0 + 1e-6);
        (low - self.centre).cmpge(-half).all() && (high - self.centre).cmple(half).all()
    }

    /// Lowest corner relative to the centre, world units.
    pub fn min(&self) -> Vec3 {
        Vec3::from_array(self.size.map(|n| -(n as f32) / 2.0)) * self.voxel_size
    }

    /// Levels, each half as many cells a side as the one before.
    pub fn levels(&self) -> u32 {
        level_count(self.size)
    }

    /// `struct Grid` in wgsl/common/grid.wgsl, for voxels that sum the attributes of so many triangles, whose emission is at
    /// most `emission_max`. World positions are relative to `origin`.
    pub fn uniform(&self, origin: DVec3, triangles: u32, emission_max: f32) -> Vec<u8> {
        let mut words = Vec::new();
        let min = (self.centre - origin).as_vec3() + self.min();
        words.extend(min.to_array().map(f32::to_bits));
        words.push(self.voxel_size.to_bits());
        words.extend(self.size);
        words.push(self.levels());
        words.push(fixed_point_scale(triangles).to_bits());
        words.push(emission_max.max(f32::MIN_POSITIVE).to_bits());
        let (offsets, bitmask) = self.word_offsets();
        words.extend([bitmask, 0]);
        words.extend(offsets);
        words.resize(28, 0);
        words.into_iter().flat_map(u32::to_le_bytes).collect()
    }

    /// Words of the bitmask at a level: bricks of 4 × 4 × 2 cells, one bit each.
    pub fn level_words(&self, level: u32) -> u32 {
        let [x, y, z] = self.size.map(|n| n >> level);
        x.div_ceil(4) * y.div_ceil(4) * z.div_ceil(2)
    }

    /// Words of the columns of bits at each level (VGI §4.1): half as many along x and y as at the level before, up to a single
    /// one, and always all of z.
    pub fn column_words(&self) -> Vec<u32> {
        let [x, y, z] = self.size;
        let levels = x.max(y).next_power_of_two().ilog2() + 1;
        let words =
            |level: u32| [x, y].map(|n| n.div_ceil(1 << level)).iter().product::<u32>() * z.div_ceil(32);
        (0..levels).map(words).collect()
    }

    /// Words of the distances between blocks of 4 × 4 × 4 cells, a byte each in rows along x: see wgsl/common/leap.wgsl.
    pub fn leap_words(&self) -> u32 {
        let [x, y, z] = self.size.map(|n| n.div_ceil(4));
        x.div_ceil(4) * y * z
    }

    /// First word of each level, and the number of words of all.
    pub fn word_offsets(&self) -> (Vec<u32>, u32) {
        let mut total = 0;
        let offsets = (0..self.levels())
            .map(|level| {
                let first = total;
                total += self.level_words(level);
                first
            })
            .collect();
        (offsets, total)
    }
}

/// What every side is a multiple of: so that the coarsest level has at most 16 cells a side, and there are three levels.
fn multiple(resolution: u32) -> u32 {
    (resolution.next_power_of_two() / 16).max(4)
}

/// Fixed-point units per 1.0 such that the sum of one contribution of each of `triangles`, each at most 1.0, never
/// overflows 32 bits. At most 2²⁰, so that a contribution rounds to exactly these units in `f32`.
pub fn fixed_point_scale(triangles: u32) -> f32 {
    (u32::MAX / triangles.max(1)).min(1 << 20) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sum_of_contributions_overflows() {
        for triangles in [0, 1, 2, 46, 262_267, 1_000_000, 7_000_000, 100_000_000] {
            let scale = fixed_point_scale(triangles);
            // What the shader adds for 1.0, as its f32 arithmetic gives it.
            let most = u64::from(scale as u32);
            assert!(u64::from(triangles.max(1)) * most <= u64::from(u32::MAX), "{triangles}");
            assert!(most >= 42);
        }
    }

    #[test]
    fn walls_run_through_the_middle_of_voxels() {
        let grid = Grid::fit(64, Some((DVec3::splat(10.0), DVec3::new(11.0, 14.0, 12.0))));
        let voxel = |y: f64| (y - grid.centre.y - f64::from(grid.min().y)) / f64::from(grid.voxel_size);
        assert!((voxel(10.0) - 1.5).abs() < 1e-4 && (voxel(14.0) - 62.5).abs() < 1e-4);
    }

    #[test]
    fn every_level_halves_exactly() {
        let bounds = Some((DVec3::ZERO, DVec3::new(3.0, 1.0, 0.01)));
        for resolution in Grid::RESOLUTIONS {
            for extent in [Extent::Cubic, Extent::Bounds, Extent::Box(DVec3::ZERO, DVec3::new(0.1, 7.0, 2.0))]
            {
                let grid = Grid::new(resolution, extent, bounds);
                assert!(grid.levels() >= 3, "{resolution} {extent:?}");
                let coarsest = grid.size.map(|n| n >> (grid.levels() - 1));
                for (n, coarse) in grid.size.into_iter().zip(coarsest) {
                    assert_eq!(coarse << (grid.levels() - 1), n, "{resolution} {extent:?}");
                    assert!(n <= 512 && coarse <= 16, "{resolution} {extent:?}");
                }
                let longest = grid.size.into_iter().max().unwrap_or(0);
                assert!(longest - resolution < resolution.next_power_of_two().div_ceil(16).max(4));
                assert!(
                    extent == Extent::Box(DVec3::ZERO, DVec3::new(0.1, 7.0, 2.0))
                        || bounds.is_some_and(|bounds| grid.holds(bounds))
                );
            }
        }
        assert_eq!(Grid::fit(64, bounds).levels(), 7);
    }

    #[test]
    fn a_box_is_as_given() {
        let grid = Grid::new(40, Extent::Box(DVec3::ZERO, DVec3::new(4.0, 2.0, 1.0)), None);
        assert_eq!((grid.size, grid.voxel_size), ([40, 20, 12], 0.1));
        // 10 of 12 voxels along z: one of padding on either side.
        assert!((grid.centre - DVec3::new(2.0, 1.0, 0.5)).length() < 1e-9);
        assert!(!grid.holds((DVec3::ZERO, DVec3::splat(3.0))));
        // Thinner than a voxel by far.
        let thin = DVec3::new(1e9, 1.0, 1.0);
        assert_eq!(Grid::new(33, Extent::Box(DVec3::ZERO, thin), None).size, [36, 4, 4]);
    }

    #[test]
    fn walls_run_through_the_middle_of_voxels_of_odd_grids() {
        for resolution in [61, 62, 63, 64, 100, 101] {
            let grid = Grid::fit(resolution, Some((DVec3::ZERO, DVec3::splat(4.0))));
            let voxel = |y: f64| (y - grid.centre.y - f64::from(grid.min().y)) / f64::from(grid.voxel_size);
            for wall in [0.0, 4.0] {
                assert!((voxel(wall).fract() - 0.5).abs() < 1e-3, "{resolution}: {}", voxel(wall));
            }
        }
    }
}
