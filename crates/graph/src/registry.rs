//! What pipelines can name.

use voxlume_format::{Encodings, Formats};
use voxlume_shader::Library;

use crate::tracer::Tracers;

/// What there is to choose from.
#[derive(Clone, Debug)]
pub struct Registry {
    /// Storage formats.
    pub formats: Formats,
    /// Texel encodings.
    pub encodings: Encodings,
    /// Tracers.
    pub tracers: Tracers,
    /// WGSL modules, those of the formats, encodings and tracers among them.
    pub library: Library,
}

impl Registry {
    /// What Voxlume brings along.
    pub fn builtin() -> Registry {
        Registry {
            formats: Formats::builtin(),
            encodings: Encodings::builtin(),
            tracers: Tracers::builtin(),
            library: Library::builtin(),
        }
    }
}
