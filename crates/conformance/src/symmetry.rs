//! The 48 symmetries of the cube.

use glam::{DVec3, UVec3};

use crate::{Content, Probe, Voxel};

/// Axes permuted, then some of them flipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// Where each axis comes from.
    pub from: [usize; 3],
    /// Whether it is flipped.
    pub flip: [bool; 3],
}

impl Symmetry {
    /// All of them, the identity first.
    pub fn all() -> Vec<Symmetry> {
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        let flips = (0..8).map(|bits| [bits & 1 != 0, bits & 2 != 0, bits & 4 != 0]);
        flips.flat_map(|flip| orders.map(|from| Symmetry { from, flip })).collect()
    }

    /// A direction turned.
    pub fn direction(&self, d: DVec3) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|i| if self.flip[i] { -d[self.from[i]] } else { d[self.from[i]] }))
    }

    /// A place in the unit cube turned.
    pub fn place(&self, uvw: DVec3) -> DVec3 {
        self.direction(uvw - 0.5) + 0.5
    }

    /// A probe turned.
    pub fn probe(&self, probe: &Probe) -> Probe {
        Probe { uvw: self.place(probe.uvw), direction: self.direction(probe.direction), ..*probe }
    }

    /// Voxels turned.
    pub fn content(&self, content: &Content) -> Content {
        let last = content.side - 1;
        let voxels = content.voxels.iter().map(|voxel| {
            let cell = [0, 1, 2].map(|i| {
                let place = voxel.cell[self.from[i]];
                if self.flip[i] { last - place } else { place }
            });
            let side = |flipped: bool| {
                DVec3::from_array([0, 1, 2].map(|i| {
                    let of = if self.flip[i] != flipped { voxel.negative } else { voxel.positive };
                    of[self.from[i]]
                }))
            };
            Voxel { cell: UVec3::from_array(cell), positive: side(false), negative: side(true), ..*voxel }
        });
        Content { side: content.side, voxels: voxels.collect() }
    }
}
