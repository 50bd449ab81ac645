//! Occupied cells of a grid as the device has them, and rays through them.

use glam::{DVec3, UVec3, Vec3};
use voxlume::{Grid, Library};

use crate::Random;
use crate::kernel::Kernel;

const KERNEL: &str = "
import package::common::ray::ray_between;
import package::walk::first_hit;

struct Case {
    origin: vec3f,
    reach: f32,
    direction: vec3f,
    padding: f32,
}

var<storage, read> cases: array<Case>;
var<storage, read_write> out: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if (i < arrayLength(&cases)) {
        let hit = first_hit(ray_between(cases[i].origin, cases[i].direction, cases[i].reach));
        let values = array(f32(hit.found), hit.distance, f32(hit.cell.x), f32(hit.cell.y), f32(hit.cell.z),
            hit.normal.x, hit.normal.y, hit.normal.z);
        for (var k = 0u; k < 8; k++) {
            out[8 * i + k] = values[k];
        }
    }
}
";

/// A ray, in voxels.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it begins.
    pub origin: Vec3,
    /// Unit.
    pub direction: Vec3,
    /// How far it goes.
    pub reach: f32,
}

/// Occupied cells of a grid.
pub struct Bits {
    /// Its voxels are a unit wide.
    pub grid: Grid,
    /// All of them.
    pub occupied: Vec<UVec3>,
    /// The bitmask of all levels.
    bitmask: Vec<u32>,
    /// The columns of bits of all levels.
    columns: Vec<u32>,
    /// How far blocks are from occupied ones.
    leaps: Vec<u32>,
    ranks: Vec<u32>,
}

impl Bits {
    /// These cells of a grid of this size.
    pub fn new(size: [u32; 3], occupied: Vec<UVec3>) -> Bits {
        let grid = Grid { size, centre: DVec3::ZERO, voxel_size: 1.0 };
        let (offsets, words) = grid.word_offsets();
        let mut occupancy = vec![0u32; words as usize];
        for level in 0..grid.levels() {
            let bricks =
                (UVec3::from_array(size.map(|n| n >> level)) + UVec3::new(3, 3, 1)) / UVec3::new(4, 4, 2);
            for cell in occupied.iter().map(|cell| *cell >> level) {
                let brick = cell / UVec3::new(4, 4, 2);
                let word = offsets[level as usize] + (brick.z * bricks.y + brick.y) * bricks.x + brick.x;
                occupancy[word as usize] |= 1 << ((cell.z & 1) * 16 + (cell.y & 3) * 4 + (cell.x & 3));
            }
        }
        let mut ranks = vec![0];
        for word in &occupancy {
            ranks.push(ranks[ranks.len() - 1] + word.count_ones());
        }
        let mut columns_of_bits = Vec::new();
        let [width, height, depth] = size;
        let height_words = depth.div_ceil(32);
        for (level, words) in (0..).zip(grid.column_words()) {
            let [columns, rows] = [width, height].map(|n| n.div_ceil(1 << level));
            assert_eq!(words, columns * rows * height_words);
            let first = columns_of_bits.len();
            columns_of_bits.resize(first + words as usize, 0);
            for cell in &occupied {
                let column = (cell.y >> level) * columns + (cell.x >> level);
                let word = column * height_words + cell.z / 32;
                columns_of_bits[first + word as usize] |= 1 << (cell.z % 32);
            }
        }
        let leaps = leaps(&grid, &occupied);
        Bits { grid, occupied, bitmask: occupancy, columns: columns_of_bits, leaps, ranks }
    }

    /// So many random cells of a hundred.
    pub fn random(size: [u32; 3], percent: f64, random: &mut Random) -> Bits {
        let [x, y, z] = size;
        let cells = (0..x * y * z).filter(|_| random.between(0.0, 100.0) < percent);
        Bits::new(size, cells.map(|i| UVec3::new(i % x, i / x % y, i / (x * y))).collect())
    }

    /// What each ray meets first, as eight values: whether it meets anything, the distance, the cell, the normal.
    ///
    /// # Panics
    /// A module is at fault, or the device.
    pub fn first_hits(&self, library: &Library, walk: &str, rays: &[Ray]) -> Vec<[f32; 8]> {
        let kernel = self.kernel(library, walk, rays);
        kernel.run(rays.len().div_ceil(64) as u32);
        kernel.values().chunks_exact(8).map(|hit| hit.try_into().unwrap_or_default()).collect()
    }

    /// The program that has each ray meet what it meets first, 64 in a workgroup.
    ///
    /// # Panics
    /// A module is at fault, or the device.
    pub fn kernel(&self, library: &Library, walk: &str, rays: &[Ray]) -> Kernel {
        let cases: Vec<f32> = rays
            .iter()
            .flat_map(|ray| {
                let [a, b, c] = ray.origin.to_array();
                let [d, e, f] = ray.direction.to_array();
                [a, b, c, ray.reach, d, e, f, 0.0]
            })
            .collect();
        let bytes = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
        let after = match walk {
            "walk/leaps" => self.leaps.as_slice(),
            "walk/columns" => &self.columns,
            _ => &[],
        };
        let (occupancy, ranks) = (bytes(&[&self.bitmask, after].concat()), bytes(&self.ranks));
        let cases: Vec<u8> = cases.iter().flat_map(|value| value.to_le_bytes()).collect();
        let grid = self.grid.uniform(DVec3::ZERO, 1, 1.0);
        let inputs: [(&str, &[u8]); 4] =
            [("grid", &grid), ("occupancy", &occupancy), ("ranks", &ranks), ("cases", &cases)];
        let mounts = [("walk", walk), ("meet", "meet/cells")];
        Kernel::new(library, KERNEL, &mounts, &[], (None, &inputs), rays.len() * 8)
    }
}

/// As wgsl/common/leap.wgsl says.
fn leaps(grid: &Grid, occupied: &[UVec3]) -> Vec<u32> {
    let size = UVec3::from_array(grid.size.map(|n| n.div_ceil(4)));
    let index = |x: u32, y: u32, z: u32| ((z * size.y + y) * size.x + x) as usize;
    let mut distances = vec![MOST_LEAP; size.element_product() as usize];
    for block in occupied.iter().map(|cell| *cell / 4) {
        distances[index(block.x, block.y, block.z)] = 0;
    }
    for axis in 0..3 {
        let before = distances.clone();
        for (z, y, x) in cells(size) {
            let at = UVec3::new(x, y, z);
            let near = |i: u32| {
                let mut other = at;
                other[axis] = i;
                before[index(other.x, other.y, other.z)].max(i.abs_diff(at[axis]))
            };
            let least = (0..size[axis]).map(near).min();
            distances[index(x, y, z)] = least.unwrap_or(MOST_LEAP).min(MOST_LEAP);
        }
    }
    let mut words = vec![0; grid.leap_words() as usize];
    for (z, y, x) in cells(size) {
        let word = (z * size.y + y) * size.x.div_ceil(4) + x / 4;
        words[word as usize] |= distances[index(x, y, z)] << (8 * (x % 4));
    }
    words
}

fn cells(size: UVec3) -> impl Iterator<Item = (u32, u32, u32)> {
    (0..size.z).flat_map(move |z| (0..size.y).flat_map(move |y| (0..size.x).map(move |x| (z, y, x))))
}

/// See wgsl/common/leap.wgsl.
const MOST_LEAP: u32 = 7;
