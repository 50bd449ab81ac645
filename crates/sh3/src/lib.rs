//! `sh3`: what is seen of a voxel from each direction, as three bands of spherical harmonics.
//!
//! **Model.** A one-sided surface of normal n in a cell of side 1 shows an observer in direction ω the area
//! A·max(n·ω, 0). That function, times radiance and as opacity, is kept in nine coefficients (Ramamoorthi and Hanrahan,
//! "An Efficient Representation for Irradiance Environment Maps", 2001, has the clamped cosine's: π/√(4π), √(π/3) and
//! √(5π)/8 for the surface's own axis). Three bands of it are 1.0625 ahead, 0.0625 behind and never below −0.04.
//!
//! **Levels.** Level 0 is isotropic. From level 1 up coefficients add up, scaled so that opacity, averaged over six
//! sides, is what the sides' children composite to: a thin wall stays opaque.
//!
//! **Bytes.** Per voxel of the grid at `rgba16float`: 8, and 9/7 of 8 more.
//!
//! **What it gets wrong.** Both sides of a wall mix by 6 %; behind a lobe opacity is up to 0.06 where it is 0.

// ANCHOR: format
use voxlume::{Choices, Formats, Library, Miss, Numbers, Property, Source, StorageFormat, Twin, Volume};

mod twin;

/// See the crate.
#[derive(Clone, Copy, Debug)]
pub struct Sh3;

impl StorageFormat for Sh3 {
    fn name(&self) -> &str {
        "sh3"
    }

    fn summary(&self) -> &str {
        "nine spherical-harmonic coefficients of radiance and opacity, from level 1 up"
    }

    fn modules(&self) -> &str {
        "format/sh3"
    }

    fn volumes(&self, _: &Choices) -> Vec<Volume> {
        let isotropic_base = true;
        Volume::directional("nine", 9, Numbers::Signed, isotropic_base)
    }
    // ANCHOR_END: format

    fn misses(&self) -> &[Miss] {
        MISSES
    }

    // ANCHOR: twin
    fn twin(&self, _: &Choices) -> Option<Box<dyn Twin>> {
        Some(Box::new(*self))
    }
    // ANCHOR_END: twin
}

// ANCHOR: misses_table
/// What nine numbers can't hold.
const MISSES: &[Miss] = &[
    Miss {
        property: Property::Sides,
        at: "",
        size: 0.0557,
        why: "three bands of a lobe are 1.0625 ahead and 0.0625 behind: 1/18 of what is seen is the other side's",
    },
    Miss {
        property: Property::Energy,
        at: "wall, level 0",
        size: 0.77,
        why: "level 0 is as opaque at a slant as head-on; from level 1 up a surface is seen at the cosine",
    },
    Miss {
        property: Property::Energy,
        at: "wall",
        size: 0.023,
        why: "what three bands show beside a lobe is composited away, about 1 % a level",
    },
    Miss {
        property: Property::Energy,
        at: "haze, level 0",
        size: 1.0,
        why: "level 0 is seen only as far as level 1 covers a quarter",
    },
    Miss {
        property: Property::Energy,
        at: "haze",
        size: 0.0071,
        why: "opacity a little below zero behind a lobe is cut off",
    },
    Miss { property: Property::Linear, at: "", size: 0.0075, why: "so is radiance, colour by colour" },
];
// ANCHOR_END: misses_table

// ANCHOR: register
/// Adds the format and its WGSL.
pub fn register(formats: &mut Formats, library: &mut Library) {
    for (path, text) in [
        ("format/sh3/basis", include_str!("../wgsl/basis.wgsl")),
        ("format/sh3/store", include_str!("../wgsl/store.wgsl")),
        ("format/sh3/mipmap", include_str!("../wgsl/mipmap.wgsl")),
        ("format/sh3/sample", include_str!("../wgsl/sample.wgsl")),
    ] {
        library.insert(path, Source::new(format!("{path}.wgsl"), text));
    }
    formats.add(Sh3);
}
// ANCHOR_END: register
