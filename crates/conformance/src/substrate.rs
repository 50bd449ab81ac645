//! The voxel substrate of given voxels, as `wgsl/common/grid.wgsl` lays it out.

use glam::{DVec3, UVec3};
use voxlume::Grid;
use voxlume::twin::{ATTRIBUTE_WORDS, VoxelSurface};

use crate::{Content, Voxel};

/// Words of the buffers, and the attributes of each voxel.
#[derive(Debug, Default)]
pub struct Substrate {
    pub occupancy: Vec<u32>,
    pub ranks: Vec<u32>,
    pub cells: Vec<u32>,
    pub levels: Vec<u32>,
    pub attributes: Vec<u32>,
    pub radiance: Vec<[f32; 4]>,
}

/// Fixed-point units per 1.0.
const SCALE: f64 = (1 << 20) as f64;

fn fixed(value: f64) -> u32 {
    (value * SCALE).round() as u32
}

/// The opacity that the device is given.
pub fn opacity(voxel: &Voxel) -> f64 {
    f64::from(fixed(voxel.opacity)) / SCALE
}

/// A voxel's attributes but its opacity: weight, weight of double-sided surfaces, reflectance (which formats don't read), normals.
fn words(voxel: &Voxel) -> [u32; ATTRIBUTE_WORDS] {
    let mut words = [0; ATTRIBUTE_WORDS];
    words[0] = fixed(1.0);
    words[1] = fixed(voxel.double_sided);
    for axis in 0..3 {
        words[5 + axis] = fixed(voxel.positive[axis]);
        words[8 + axis] = fixed(voxel.negative[axis]);
    }
    words
}

/// What a format finds of a voxel.
pub fn surface(voxel: &Voxel) -> VoxelSurface {
    VoxelSurface::of(&words(voxel))
}

impl Substrate {
    pub fn new(content: &Content) -> Substrate {
        let grid = Grid { size: [content.side; 3], centre: DVec3::ZERO, voxel_size: 1.0 };
        let (offsets, total) = grid.word_offsets();
        let mut occupancy = vec![0u32; total as usize];
        let place = |cell: UVec3, level: u32| {
            let bricks = ((content.side >> level).max(1) + UVec3::new(3, 3, 1)) / UVec3::new(4, 4, 2);
            let brick = cell / UVec3::new(4, 4, 2);
            let word = offsets[level as usize] + (brick.z * bricks.y + brick.y) * bricks.x + brick.x;
            (word as usize, (cell.z & 1) * 16 + (cell.y & 3) * 4 + (cell.x & 3))
        };
        // Every occupied cell by its place in the list.
        let mut listed = Vec::new();
        for level in 0..grid.levels() {
            for voxel in &content.voxels {
                let cell = voxel.cell >> level;
                let (word, bit) = place(cell, level);
                if occupancy[word] >> bit & 1 == 0 {
                    occupancy[word] |= 1 << bit;
                    listed.push(((word, bit), cell, level, (level == 0).then_some(voxel)));
                }
            }
        }
        listed.sort_by_key(|(place, ..)| *place);
        let mut ranks = vec![0];
        for word in &occupancy {
            ranks.push(ranks[ranks.len() - 1] + word.count_ones());
        }
        let mut substrate = Substrate { occupancy, ranks, ..Substrate::default() };
        for level in 0..grid.levels() {
            let first = listed.iter().position(|item| item.2 == level).unwrap_or(listed.len()) as u32;
            let count = listed.iter().filter(|item| item.2 == level).count() as u32;
            substrate.levels.extend([count.div_ceil(64), 1, 1, first, count, 0, 0, 0]);
        }
        for (_, cell, _, voxel) in listed {
            substrate.cells.push(cell.x | cell.y << 10 | cell.z << 20);
            if let Some(voxel) = voxel {
                substrate.attributes.extend(words(voxel));
                substrate.attributes.push(fixed(voxel.opacity));
                substrate.radiance.push(voxel.radiance.extend(1.0).as_vec4().to_array());
            }
        }
        substrate
    }
}
