//! What there is to choose from.

use voxlume::{Formats, Library};

/// What there is to choose from.
pub struct Registry {
    /// Storage formats.
    pub formats: Formats,
    /// WGSL modules, those of the formats among them.
    pub library: Library,
}

impl Registry {
    /// What Voxlume brings along.
    pub fn builtin() -> Registry {
        Registry { formats: Formats::builtin(), library: Library::builtin() }
    }
}
