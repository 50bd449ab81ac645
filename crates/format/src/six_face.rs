//! `six_face`: one value for each side from which a voxel is seen (RAU §5.1.2, DVS §1.1 and §3).
//!
//! Level 0 is isotropic and shared; from level 1 up each of six faces composites the nearer child over the
//! farther and averages the four columns. Per voxel of the grid at `rgba16float`: 8 bytes and 6/7 of 8 more. With
//! any other `base` the faces begin at level 0: 48 bytes and 1/7 of 48 more.

use glam::{DVec3, DVec4, UVec3};

use crate::twin::{Twin, Volumes, children, composite_columns};
use crate::{Choices, FormatOption, Miss, Numbers, Property, StorageFormat, Volume};

/// See the module.
#[derive(Clone, Copy, Debug)]
pub struct SixFace;

const BASE: FormatOption = FormatOption {
    name: "base",
    summary: "level 0: one value for all faces (isotropic), all of it on the face that the normal is nearest to \
              (dominant), on the three faces that the normal points to by the squares of its components (weighted), or by \
              their cosines (cosine)",
    words: &["isotropic", "dominant", "weighted", "cosine"],
};

const EMPTY: FormatOption = FormatOption {
    name: "empty",
    summary: "faces of a directional level 0 that the normal gives nothing: transparent (clear), opaque without \
              light (black), or as the voxel's value (fill)",
    words: &["clear", "black", "fill"],
};

impl StorageFormat for SixFace {
    fn name(&self) -> &str {
        "six_face"
    }

    fn summary(&self) -> &str {
        "a radiance and opacity for each of six directions, from level 1 up"
    }

    fn modules(&self) -> &str {
        "format/six_face"
    }

    fn options(&self) -> &[FormatOption] {
        &[BASE, EMPTY]
    }

    fn volumes(&self, choices: &Choices) -> Vec<Volume> {
        Volume::directional("faces", 6, Numbers::Radiance, choices.word(&BASE) == "isotropic")
    }

    fn misses(&self) -> &[Miss] {
        &[
            Miss {
                property: Property::Energy,
                at: "wall, level 0",
                size: 0.65,
                why: "level 0 is as opaque at a slant as head-on; from level 1 up a face is seen at the cosine",
            },
            Miss {
                property: Property::Energy,
                at: "haze, level 0",
                size: 1.0,
                why: "level 0 is seen only as far as level 1 covers a quarter",
            },
        ]
    }

    fn twin(&self, choices: &Choices) -> Option<Box<dyn Twin>> {
        Some(Box::new(SixFaceTwin { base: choices.word(&BASE), empty: choices.word(&EMPTY) }))
    }
}

/// `wgsl/format/six_face`.
struct SixFaceTwin {
    base: &'static str,
    empty: &'static str,
}

const FACES: u32 = 6;

fn face_of(axis: usize, negative: bool) -> u32 {
    2 * axis as u32 + u32::from(negative)
}

impl SixFaceTwin {
    fn isotropic_base(&self) -> bool {
        self.base == "isotropic"
    }

    /// The volume of the faces; `base`, where it is, comes first.
    fn faces(&self) -> usize {
        usize::from(self.isotropic_base())
    }

    /// How much of a surface of this normal a face shows.
    fn face_weight(&self, normal: DVec3, face: u32) -> f64 {
        if normal == DVec3::ZERO {
            return 1.0;
        }
        let (axis, size) = (face as usize / 2, normal.abs());
        let cosine = if face % 2 == 1 { -normal[axis] } else { normal[axis] }.max(0.0);
        match self.base {
            "dominant" => f64::from(u8::from(cosine > 0.0 && axis == size.max_position())),
            "weighted" => cosine * cosine,
            _ => cosine,
        }
    }

    fn child(&self, volumes: &Volumes, cell: UVec3, level: u32, axis: usize, side: u32) -> DVec4 {
        if level > 1 || !self.isotropic_base() {
            return volumes.load_block(self.faces(), level - 1, cell, face_of(axis, side == 1));
        }
        let value = volumes.level(0, 0).load(cell);
        let Some(surface) = volumes.surface(cell).filter(|_| value.w > 0.0) else { return DVec4::ZERO };
        value * if side == 1 { surface.back } else { surface.front }[axis]
    }

    fn sample_faces(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let face = |axis: usize| {
            let face = face_of(axis, direction[axis] > 0.0);
            direction[axis].abs() * volumes.sample_block(self.faces(), face, uvw, level)
        };
        let value: DVec4 = (0..3).map(face).sum();
        value / value.w.max(1.0)
    }
}

impl Twin for SixFaceTwin {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, normal: DVec3, opacity: f64) {
        let value = (radiance * opacity).extend(opacity);
        if self.isotropic_base() {
            volumes.level_mut(0, 0).store(cell, value);
            return;
        }
        for face in 0..FACES {
            let weight = self.face_weight(normal, face);
            let seen = match self.empty {
                "black" if weight == 0.0 => DVec3::ZERO.extend(opacity),
                "fill" if weight == 0.0 => value,
                _ => value * weight,
            };
            volumes.store_block(self.faces(), 0, cell, face, seen);
        }
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        for axis in 0..3 {
            for side in 0..2 {
                let seen = children(cell).map(|child| self.child(volumes, child, level, axis, side));
                let seen = composite_columns(&seen, axis, 1 - side as usize);
                volumes.store_block(self.faces(), level, cell, face_of(axis, side == 1), seen);
            }
        }
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        if !self.isotropic_base() {
            return self.sample_faces(volumes, uvw, level, direction);
        }
        let coarse = self.sample_faces(volumes, uvw, (level - 1.0).max(0.0), direction);
        volumes.sample_over_base(0, uvw, level, coarse)
    }
}
