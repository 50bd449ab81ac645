//! Voxel storage formats: which volumes each needs and which WGSL modules it is made of.
//!
//! A format is a directional basis; an [`Encoding`] is how its numbers are stored. A format gives three WGSL
//! modules under `package::format`: `store` with `voxel_store`, `sample` with `voxel_sample` and `mipmap` with
//! `voxel_mipmap`. All numbers are premultiplied: radiance times opacity, and the opacity.
//!
//! The built-in ones are in [`Formats::builtin`]; a format of another crate implements [`StorageFormat`] and
//! is added with [`Formats::add`].

use std::sync::Arc;

mod encoding;
mod isotropic;
mod sh2;
mod six_face;
mod volume;

pub use encoding::Encoding;
pub use isotropic::Isotropic;
pub use sh2::Sh2;
pub use six_face::SixFace;
pub use volume::{Levels, Volume, level_count};

/// A directional basis for radiance and opacity in voxels.
pub trait StorageFormat: std::fmt::Debug + Send + Sync {
    /// The word in RON and on the command line.
    fn name(&self) -> &str;

    /// What it models, in a sentence.
    fn summary(&self) -> &str;

    /// Path of the folder of its WGSL modules in the shader library, such as `format/isotropic`.
    fn modules(&self) -> &str;

    /// The 3D textures that it keeps. WGSL reads each under its name, writes its level 0 under
    /// `<name>_level0`, and in `voxel_mipmap` reads `<name>_source` and writes `<name>_target`.
    fn volumes(&self) -> &[Volume];
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
mod tests {
    use super::*;

    /// One shared level 0, directions from level 1 up.
    #[test]
    fn bytes_at_128() {
        let formats = Formats::builtin();
        let mebibytes = |name| {
            let volumes = formats.get(name).map(StorageFormat::volumes).unwrap_or_default();
            let bytes: u64 = volumes.iter().map(|v| v.bytes([128; 3], Encoding::Rgba16Float)).sum();
            bytes as f64 / f64::from(1 << 20)
        };
        // 8 bytes a texel: 16 MiB of level 0 and, from level 1 up, 16/7 MiB (less the last level's rounding) a block.
        assert!((mebibytes("isotropic") - 18.2857).abs() < 1e-3, "{}", mebibytes("isotropic"));
        assert!((mebibytes("six_face") - 29.714).abs() < 2e-3, "{}", mebibytes("six_face"));
        assert!((mebibytes("sh2") - 25.1428).abs() < 2e-3, "{}", mebibytes("sh2"));
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
