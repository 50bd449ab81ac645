//! A storage format with all that is chosen about it.

use voxlume_format::{Choices, Encoding, StorageFormat, Volume};

/// A storage format with all that is chosen about it.
#[derive(Clone, Debug)]
pub(crate) struct Storage<'a> {
    format: &'a dyn StorageFormat,
    choices: Choices,
    pub encoding: Encoding,
    filters_float32: bool,
}

impl<'a> Storage<'a> {
    pub fn new(
        format: &'a dyn StorageFormat,
        choices: Choices,
        encoding: Encoding,
        filters_float32: bool,
    ) -> Storage<'a> {
        Storage { format, choices, encoding, filters_float32 }
    }

    pub fn volumes(&self) -> Vec<Volume> {
        self.format.volumes(&self.choices)
    }

    /// `sh2:mip=projected`
    pub fn word(&self) -> String {
        format!("{}{}", self.format.name(), self.choices)
    }

    /// The folder of the format's WGSL modules.
    pub fn modules(&self) -> &str {
        self.format.modules()
    }

    /// What its modules are mounted as: those of the format, of the encoding, and of how textures are filtered.
    pub fn mounts(&self) -> [(&'static str, String); 3] {
        [
            ("format", self.format.modules().to_owned()),
            ("encoding", self.encoding.module.to_owned()),
            ("filter", self.encoding.texel.filter(self.filters_float32).to_owned()),
        ]
    }

    /// The `override` of each option of the format, and the word chosen for it.
    pub fn words(&self) -> impl Iterator<Item = (String, &'static str)> {
        self.format.options().iter().map(|option| (option.name.to_uppercase(), self.choices.word(option)))
    }
}
