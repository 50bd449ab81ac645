//! `six_face`: one value for each side from which a voxel is seen (RAU §5.1.2, DVS §1.1 and §3).
//!
//! Level 0 is isotropic and shared; from level 1 up each of six faces composites the nearer child over the
//! farther and averages the four columns. Per voxel of the grid at `rgba16float`: 8 bytes and 6/7 of 8 more. With
//! any other `base` the faces begin at level 0: 48 bytes and 1/7 of 48 more.

use glam::{DVec3, DVec4, UVec3};

use crate::twin::{Twin, Volumes};
use crate::{Choices, FormatOption, Miss, Property, StorageFormat, Volume};

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
        Volume::directional("faces", 6, false, choices.word(&BASE) == "isotropic")
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

    fn twin(&self) -> Option<&dyn Twin> {
        Some(self)
    }
}

const BASE_VOLUME: usize = 0;
const FACES_VOLUME: usize = 1;
const FACES: u32 = 6;
/// From this coverage by level 1 on, level 0 counts in full.
const FACING_FULL: f64 = 0.25;

fn face_of(axis: usize, negative: bool) -> u32 {
    2 * axis as u32 + u32::from(negative)
}

fn child(volumes: &Volumes, cell: UVec3, level: u32, axis: usize, side: u32) -> DVec4 {
    if level > 1 {
        let faces = volumes.level(FACES_VOLUME, level - 1);
        return faces.load(cell + UVec3::Z * (face_of(axis, side == 1) * faces.size.z / FACES));
    }
    let value = volumes.level(BASE_VOLUME, 0).load(cell);
    let Some(surface) = volumes.surface(cell).filter(|_| value.w > 0.0) else { return DVec4::ZERO };
    value * if side == 1 { surface.back } else { surface.front }[axis]
}

fn sample_faces(volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
    let half_texel = 0.5 * level.ceil().exp2() / f64::from(volumes.side >> 1);
    let w = uvw.z.clamp(half_texel, 1.0 - half_texel);
    let face = |axis: usize| {
        let block = f64::from(face_of(axis, direction[axis] > 0.0));
        let value = volumes.sample(FACES_VOLUME, uvw.with_z((block + w) / f64::from(FACES)), level);
        direction[axis].abs() * value
    };
    let value = face(0) + face(1) + face(2);
    value / value.w.max(1.0)
}

impl Twin for SixFace {
    fn voxel_store(&self, volumes: &mut Volumes, cell: UVec3, radiance: DVec3, _: DVec3, opacity: f64) {
        volumes.level_mut(BASE_VOLUME, 0).store(cell, (radiance * opacity).extend(opacity));
    }

    fn voxel_mipmap(&self, volumes: &mut Volumes, cell: UVec3, level: u32) {
        for axis in 0..3 {
            let along = UVec3::AXES[axis];
            let (u, v) = (UVec3::AXES[(axis + 1) % 3], UVec3::AXES[(axis + 2) % 3]);
            for side in 0..2 {
                let column = |column: u32| {
                    let low = cell * 2 + u * (column & 1) + v * (column >> 1);
                    let near = child(volumes, low + along * (1 - side), level, axis, side);
                    let far = child(volumes, low + along * side, level, axis, side);
                    near + (1.0 - near.w) * far
                };
                let sum: DVec4 = (0..4).map(column).sum();
                let faces = volumes.level_mut(FACES_VOLUME, level);
                let block = UVec3::Z * (face_of(axis, side == 1) * faces.size.z / FACES);
                faces.store(cell + block, sum / 4.0);
            }
        }
    }

    fn voxel_sample(&self, volumes: &Volumes, uvw: DVec3, level: f64, direction: DVec3) -> DVec4 {
        let coarse = sample_faces(volumes, uvw, (level - 1.0).max(0.0), direction);
        if level >= 1.0 {
            return coarse;
        }
        let fine = volumes.sample(BASE_VOLUME, uvw, 0.0) * (coarse.w / FACING_FULL).clamp(0.0, 1.0);
        fine.lerp(coarse, level.max(0.0))
    }
}
