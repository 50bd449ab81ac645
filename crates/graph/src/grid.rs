//! The voxel grid and the layout of its bitmask.

use glam::{DVec3, Vec3};
use voxlume_format::level_count;

/// A cubic grid fitted around a scene. World positions inside are relative to its centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Voxels along x, y, z.
    pub size: [u32; 3],
    /// World position of the grid's centre.
    pub centre: DVec3,
    /// Side of a voxel, world units.
    pub voxel_size: f32,
}

impl Grid {
    /// Sizes to choose from.
    pub const RESOLUTIONS: [u32; 6] = [16, 32, 64, 128, 256, 512];

    /// The scene's longest side spans all but three voxels, so that its outermost walls run through the
    /// middle of a voxel and one empty voxel remains around it.
    pub fn fit(resolution: u32, bounds: Option<(DVec3, DVec3)>) -> Grid {
        let (low, high) = bounds.unwrap_or((DVec3::splat(-0.5), DVec3::splat(0.5)));
        let longest = (high - low).max_element();
        // A scene without extent still gets voxels of a size that f64 positions can tell apart.
        let least = (low.abs().max(high.abs()).max_element() * 1e-9).max(1e-30);
        let voxel_size = longest.max(least) / f64::from(resolution - 3);
        Grid { size: [resolution; 3], centre: (low + high) / 2.0, voxel_size: voxel_size as f32 }
    }

    /// Lowest corner relative to the centre, world units.
    pub fn min(&self) -> Vec3 {
        Vec3::from_array(self.size.map(|n| -(n as f32) / 2.0)) * self.voxel_size
    }

    /// Levels down to the one of a single cell.
    pub fn levels(&self) -> u32 {
        level_count(self.size)
    }

    /// Words of the bitmask at a level: bricks of 4 × 4 × 2 cells, one bit each.
    pub fn level_words(&self, level: u32) -> u32 {
        let [x, y, z] = self.size.map(|n| (n >> level).max(1));
        x.div_ceil(4) * y.div_ceil(4) * z.div_ceil(2)
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
}
