//! The voxel substrate as the device holds it.
#![allow(clippy::panic)]

use glam::{DVec3, UVec3};
use voxlume::scene::Geometry;
use voxlume::{Grid, Renderer, ResourceKind, Scene};

/// The buffers of `voxels`, read back.
#[derive(Clone, Debug, PartialEq)]
pub struct Substrate {
    /// The grid.
    pub grid: Grid,
    /// One bit a cell, every level.
    pub occupancy: Vec<u32>,
    /// Bits set before each word, and in all.
    pub ranks: Vec<u32>,
    /// Every occupied cell, packed 10 bits a coordinate, levels one after the other.
    pub cells: Vec<u32>,
    /// Each level's part of `cells`.
    pub levels: Vec<Run>,
    /// Fixed-point sums of each occupied voxel.
    pub attributes: Vec<u32>,
    /// Each occupied voxel's sheets, and what its sides are (wgsl/common/sheet.wgsl).
    pub sheets: Vec<Vec<u32>>,
}

/// One level's part of the list of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// Workgroups of 64 that cover it.
    pub groups: [u32; 3],
    /// First index.
    pub first: u32,
    /// How many.
    pub count: u32,
}

/// What a voxel's sums say: means of what its surfaces show, by weight.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// Reflectance.
    pub albedo: DVec3,
    /// Unit if the voxel has surfaces of one normal.
    pub normal: DVec3,
    /// Share of double-sided surfaces.
    pub double_sided: f64,
    /// Over the brightest channel of the scene's materials; zero if none emits.
    pub emission: DVec3,
}

impl Surface {
    /// Decodes the sums, laid out as wgsl/common/attributes.wgsl says.
    pub fn of(sums: &[u32]) -> Surface {
        let mean = |word: usize| f64::from(sums[word]) / f64::from(sums[0]);
        let vector = |first: usize| DVec3::new(mean(first), mean(first + 1), mean(first + 2));
        Surface {
            albedo: vector(2),
            normal: vector(5) - vector(8),
            double_sided: mean(1),
            emission: if sums.len() > 13 { vector(11) } else { DVec3::ZERO },
        }
    }
}

impl Substrate {
    /// Reads the buffers.
    ///
    /// # Panics
    /// The plan has no voxels, or the device is lost.
    pub fn read(renderer: &Renderer<'_>) -> Substrate {
        let words = |name: &str| -> Vec<u32> {
            let bytes = renderer.buffer(name).unwrap_or_else(|error| panic!("{error}"));
            let bytes = bytes.unwrap_or_else(|| panic!("the plan has no `{name}`"));
            bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
        };
        // `struct LevelRun` in wgsl/common/grid.wgsl takes eight words.
        let levels = words("levels");
        let levels =
            levels.chunks_exact(8).map(|w| Run { groups: [w[0], w[1], w[2]], first: w[3], count: w[4] });
        // Buffers may be larger than what they hold.
        let (voxels, listed) = renderer.counts();
        let kind = |name: &str| {
            let plan = renderer.plan();
            let index = plan.resource(name).unwrap_or_else(|| panic!("the plan has no `{name}`"));
            let (ResourceKind::PerVoxel(bytes) | ResourceKind::PerCell(bytes)) = plan.resources[index].kind
            else {
                panic!("`{name}` holds something else");
            };
            bytes as usize / 4
        };
        let held = |name: &str, count: u64| {
            let mut words = words(name);
            words.truncate(kind(name) * count as usize);
            words
        };
        Substrate {
            grid: renderer.plan().grid.clone(),
            // What rays walk through follows the bitmask.
            occupancy: words("occupancy")[..renderer.plan().grid.word_offsets().1 as usize].to_vec(),
            ranks: words("ranks"),
            cells: held("cells", listed),
            levels: levels.collect(),
            attributes: held("attributes", voxels),
            sheets: sheets(&words("sheets"), kind("sheets"), voxels),
        }
    }

    /// Cells along each axis at a level.
    pub fn size(&self, level: u32) -> UVec3 {
        UVec3::from_array(self.grid.size.map(|n| n >> level))
    }

    /// Word and bit of a cell: bricks of 4 × 4 × 2 cells.
    pub fn place(&self, cell: UVec3, level: u32) -> (usize, u32) {
        let bricks = (self.size(level) + UVec3::new(3, 3, 1)) / UVec3::new(4, 4, 2);
        let brick = cell / UVec3::new(4, 4, 2);
        let first = self.grid.word_offsets().0[level as usize];
        let word = first + (brick.z * bricks.y + brick.y) * bricks.x + brick.x;
        (word as usize, (cell.z & 1) * 16 + (cell.y & 3) * 4 + (cell.x & 3))
    }

    /// Whether a cell's bit is set.
    pub fn is_set(&self, cell: UVec3, level: u32) -> bool {
        let (word, bit) = self.place(cell, level);
        self.occupancy[word] >> bit & 1 == 1
    }

    /// The cells listed for a level.
    pub fn listed(&self, level: u32) -> Vec<UVec3> {
        let Run { first, count, .. } = self.levels[level as usize];
        let run = &self.cells[first as usize..(first + count) as usize];
        run.iter().map(|word| UVec3::new(word & 1023, word >> 10 & 1023, word >> 20)).collect()
    }

    /// The attribute sums of a voxel, if it is occupied.
    pub fn sums(&self, cell: UVec3) -> Option<&[u32]> {
        self.voxels().nth(self.slot(cell)?)
    }

    /// A voxel's place among the occupied ones.
    fn slot(&self, cell: UVec3) -> Option<usize> {
        let (word, bit) = self.place(cell, 0);
        let below = (self.occupancy[word] & ((1 << bit) - 1)).count_ones();
        self.is_set(cell, 0).then_some((self.ranks[word] + below) as usize)
    }

    /// Which of the 5 × 5 squares of a voxel's face along an axis its surfaces cover, the first row along the next axis; `None` if
    /// it has no sheet there.
    pub fn squares(&self, cell: UVec3, axis: u32) -> Option<[bool; 25]> {
        let entries = &self.sheets[self.slot(cell)?][..2 * 6];
        let bits = entries.chunks_exact(2).map(|sheet| sheet[1]);
        let bits = bits.into_iter().find(|bits| bits >> 31 == 1 && bits >> 25 & 3 == axis)?;
        Some(std::array::from_fn(|square| bits >> square & 1 == 1))
    }

    /// The base colour of each of a voxel's six sides: towards +x, −x, +y and so on.
    pub fn side_colors(&self, cell: UVec3) -> Option<[DVec3; 6]> {
        let words = &self.sheets[self.slot(cell)?][2 * 6..];
        let channel =
            |word: u32, shift: u32, most: u32| (f64::from(word >> shift & most) / f64::from(most)).powi(2);
        Some(std::array::from_fn(|side| {
            let word = words[side];
            DVec3::new(channel(word, 0, 511), channel(word, 9, 511), channel(word, 18, 255))
        }))
    }

    /// The attribute sums of each occupied voxel.
    pub fn voxels(&self) -> impl Iterator<Item = &[u32]> {
        let count = self.levels[0].count as usize;
        let stride = self.attributes.len().checked_div(count).unwrap_or(1);
        self.attributes.chunks_exact(stride).take(count)
    }

    /// A scene's triangles in voxel coordinates, from the same `f32` positions that the device gets.
    pub fn triangles(&self, scene: &Scene) -> Vec<[DVec3; 3]> {
        let geometry = Geometry::new(scene, self.grid.centre);
        let (low, size) = (self.grid.min().as_dvec3(), f64::from(self.grid.voxel_size));
        let place = |i: u32| (geometry.positions[i as usize].as_dvec3() - low) / size;
        geometry.triangles.iter().map(|triangle| triangle.map(place)).collect()
    }
}

/// From entries of two words, of which all voxels' first ones come first; the buffer may have room for more voxels.
fn sheets(words: &[u32], of_voxel: usize, voxels: u64) -> Vec<Vec<u32>> {
    let room = words.len() / of_voxel;
    let entry = |slot: usize, index: usize| &words[2 * (index * room + slot)..][..2];
    let voxel = |slot| (0..of_voxel / 2).flat_map(|index| entry(slot, index).to_vec()).collect();
    (0..voxels as usize).map(voxel).collect()
}
