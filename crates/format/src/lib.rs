//! Voxel storage formats: which volumes each needs and which WGSL modules it is made of.
//!
//! A format is a directional basis; an [`Encoding`] is how its numbers are stored. A format gives three WGSL
//! modules under `package::format`: `store` with `voxel_store`, `sample` with `voxel_sample`, and `mipmap` with
//! `voxel_mipmap`. All numbers are premultiplied: radiance times opacity, and the opacity.
//!
//! The built-in ones are in [`Formats::builtin`]; a format of another crate implements [`StorageFormat`] and
//! is added with [`Formats::add`].

use std::sync::Arc;

mod encoding;
mod isotropic;
mod option;
mod property;
mod sh2;
mod six_face;
pub mod twin;
mod volume;

pub use encoding::{Encoding, Encodings, Texel};
pub use isotropic::Isotropic;
pub use option::{Choices, FormatOption};
pub use property::{Miss, Property};
pub use sh2::Sh2;
pub use six_face::SixFace;
pub use twin::Twin;
pub use volume::{Levels, Numbers, Volume, level_count};

/// A directional basis for radiance and opacity in voxels.
pub trait StorageFormat: std::fmt::Debug + Send + Sync {
    /// The word in RON and on the command line.
    fn name(&self) -> &str;

    /// What it models, in a sentence.
    fn summary(&self) -> &str;

    /// Path of the folder of its WGSL modules in the shader library, such as `format/isotropic`; it is below `format`.
    fn modules(&self) -> &str;

    /// What can be chosen about it.
    fn options(&self) -> &[FormatOption] {
        &[]
    }

    /// The 3D textures that it keeps with these choices. WGSL reads each under its name, writes its level 0 under
    /// `<name>_level0`, and in `voxel_mipmap` reads `<name>_source` and writes `<name>_target`; textures of its modules
    /// that belong to none of them are bound to one texel of zeroes.
    fn volumes(&self, choices: &Choices) -> Vec<Volume>;

    /// What it can't hold by nature with its default choices, and by how much.
    fn misses(&self) -> &[Miss] {
        &[]
    }

    /// The same on the CPU in `f64` with these choices, for tests to hold the WGSL against.
    fn twin(&self, _choices: &Choices) -> Option<Box<dyn Twin>> {
        None
    }
}

/// The formats to choose from.
#[derive(Clone, Debug)]
pub struct Formats(Vec<Arc<dyn StorageFormat>>);

impl Formats {
    /// The formats of this crate.
    pub fn builtin() -> Formats {
        Formats(vec![Arc::new(Isotropic), Arc::new(SixFace), Arc::new(Sh2)])
    }

    /// Adds a format; one of the same name gives way.
    pub fn add(&mut self, format: impl StorageFormat + 'static) {
        self.0.retain(|other| other.name() != format.name());
        self.0.push(Arc::new(format));
    }

    /// The format called `name`.
    pub fn get(&self, name: &str) -> Option<&dyn StorageFormat> {
        self.iter().find(|format| format.name() == name)
    }

    /// All of them, in the order added.
    pub fn iter(&self) -> impl Iterator<Item = &dyn StorageFormat> {
        self.0.iter().map(Arc::as_ref)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// MiB of a format with an option's word, at 128³ and `rgba16float`.
    fn mebibytes(name: &str, base: &str) -> f64 {
        let formats = Formats::builtin();
        let format = formats.get(name).unwrap();
        let mut choices = Choices::default();
        format.options().iter().take(1).for_each(|option| choices.choose(option, base));
        let volumes = format.volumes(&choices);
        let bytes: u64 = volumes.iter().map(|v| v.bytes([128; 3], Encoding::RGBA16FLOAT)).sum();
        bytes as f64 / f64::from(1 << 20)
    }

    /// 8 bytes a texel: 16 MiB a block of level 0 and, from level 1 up, 16/7 MiB a block less the last level's rounding.
    #[test]
    fn bytes_at_128() {
        for (name, base, expected) in [
            ("isotropic", "", 128.0 / 7.0),
            ("six_face", "isotropic", 16.0 + 6.0 * 16.0 / 7.0),
            ("six_face", "cosine", 6.0 * 128.0 / 7.0),
            ("sh2", "isotropic", 16.0 + 4.0 * 16.0 / 7.0),
            ("sh2", "lobe", 4.0 * 128.0 / 7.0),
        ] {
            let got = mebibytes(name, base);
            assert!((got - expected).abs() < 2e-3, "{name} {base}: {got}, {expected}");
        }
    }

    #[test]
    fn a_format_of_the_same_name_gives_way() {
        let mut formats = Formats::builtin();
        formats.add(Sh2);
        assert_eq!(
            formats.iter().map(StorageFormat::name).collect::<Vec<_>>(),
            ["isotropic", "six_face", "sh2"]
        );
    }
}
