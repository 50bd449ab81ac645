//! Voxels to be stored.

use glam::{DVec3, UVec3};

/// A voxel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Voxel {
    /// Where it is.
    pub cell: UVec3,
    /// W·m⁻²·sr⁻¹
    pub radiance: DVec3,
    /// `[0, 1]`
    pub opacity: f64,
    /// Mean of its surfaces' unit normals, positive components alone.
    pub positive: DVec3,
    /// The negative ones, as positive numbers.
    pub negative: DVec3,
    /// Share of its surfaces that are double-sided.
    pub double_sided: f64,
}

impl Voxel {
    /// A one-sided opaque surface of this unit normal.
    pub fn facing(cell: UVec3, normal: DVec3, radiance: DVec3) -> Voxel {
        let (positive, negative) = (normal.max(DVec3::ZERO), (-normal).max(DVec3::ZERO));
        Voxel { cell, radiance, opacity: 1.0, positive, negative, double_sided: 0.0 }
    }

    /// Surfaces that face all ways.
    pub fn all_round(cell: UVec3, radiance: DVec3) -> Voxel {
        let half = DVec3::splat(0.5 / 3f64.sqrt());
        Voxel { cell, radiance, opacity: 1.0, positive: half, negative: half, double_sided: 1.0 }
    }
}

/// Voxels in a cubic grid; no cell twice.
#[derive(Clone, Debug, PartialEq)]
pub struct Content {
    /// Voxels along each side.
    pub side: u32,
    /// The occupied ones.
    pub voxels: Vec<Voxel>,
}

/// Seeded random numbers: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
#[derive(Debug)]
pub(crate) struct Random(pub u64);

impl Random {
    /// In `[0, 1)`.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }

    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.vector() * 2.0 - 1.0;
            if (0.1..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }
}

impl Content {
    /// The cells where `voxel` gives something.
    pub fn of(side: u32, mut voxel: impl FnMut(UVec3) -> Option<Voxel>) -> Content {
        let cells = (0..side.pow(3)).map(|i| UVec3::new(i % side, i / side % side, i / (side * side)));
        Content { side, voxels: cells.filter_map(&mut voxel).collect() }
    }

    /// All cells the same, from all sides.
    pub fn constant(side: u32, radiance: DVec3) -> Content {
        Content::of(side, |cell| Some(Voxel::all_round(cell, radiance)))
    }

    /// A wall one voxel thick that faces along an axis.
    pub fn wall(side: u32, axis: usize, at: u32, positive: bool, radiance: DVec3) -> Content {
        let normal = if positive { DVec3::AXES[axis] } else { -DVec3::AXES[axis] };
        Content::of(side, |cell| (cell[axis] == at).then(|| Voxel::facing(cell, normal, radiance)))
    }

    /// Two walls back to back (RAU figure 5.6): red faces −axis, green +axis.
    pub fn red_green_wall(side: u32, axis: usize, at: u32) -> Content {
        let mut content = Content::wall(side, axis, at, false, DVec3::X);
        content.voxels.extend(Content::wall(side, axis, at + 1, true, DVec3::Y).voxels);
        content
    }

    /// A third of the cells, with one-sided surfaces of any normal; opacities up to `opacity`.
    pub fn random(side: u32, seed: u64, opacity: f64) -> Content {
        let mut random = Random(seed);
        Content::of(side, |cell| {
            let (kept, normal, radiance) = (random.next() < 0.33, random.direction(), random.vector());
            let share = random.next();
            kept.then(|| Voxel { opacity: opacity * share, ..Voxel::facing(cell, normal, radiance) })
        })
    }

    /// What formats stumble over, by name. Radiances stay in the range of half floats.
    pub fn adversarial(side: u32) -> Vec<(&'static str, Content)> {
        let mut random = Random(7);
        let scaled = |seed: u64, scale: f64| {
            let mut content = Content::random(side, seed, 1.0);
            content.voxels.iter_mut().for_each(|voxel| voxel.radiance *= scale);
            content
        };
        let checkerboard = Content::of(side, |cell| {
            let odd = cell.element_sum() % 2 == 1;
            Some(Voxel::all_round(cell, if odd { DVec3::X } else { DVec3::new(0.0, 2.0, 0.0) }))
        });
        let checkerboard = Content {
            voxels: checkerboard.voxels.into_iter().filter(|v| v.cell.element_sum() % 3 != 0).collect(),
            ..checkerboard
        };
        let range = Content::of(side, |cell| {
            let exponent = -24.0 + 39.9 * random.next();
            Some(Voxel::facing(cell, random.direction(), DVec3::splat(exponent.exp2())))
        });
        vec![
            ("constant", Content::constant(side, DVec3::new(0.3, 1.0, 7.0))),
            ("opposite walls", Content::red_green_wall(side, 0, 2)),
            ("checkerboard", checkerboard),
            (
                "single voxel",
                Content {
                    side,
                    voxels: vec![Voxel::facing(UVec3::new(3, 2, 1), DVec3::new(0.6, 0.0, -0.8), DVec3::ONE)],
                },
            ),
            ("random", Content::random(side, 1, 1.0)),
            ("faint", Content::random(side, 2, 1e-3)),
            ("extremes of range", range),
            ("brightest", scaled(3, 65000.0)),
            ("subnormal", scaled(4, 1e-6)),
        ]
    }
}
