//! What pipelines can name.

use voxlume_format::{Encodings, Formats};
use voxlume_shader::Library;

use crate::pass::Kinds;
use crate::tracer::Tracers;

/// What there is to choose from.
#[derive(Clone, Debug)]
pub struct Registry {
    /// Storage formats.
    pub formats: Formats,
    /// Texel encodings.
    pub encodings: Encodings,
    /// Kinds of passes.
    pub kinds: Kinds,
    /// Tracers.
    pub tracers: Tracers,
    /// WGSL modules, those of the formats, encodings, tracers and kinds among them.
    pub library: Library,
}

impl Registry {
    /// What Voxlume brings along.
    pub fn builtin() -> Registry {
        Registry {
            formats: Formats::builtin(),
            encodings: Encodings::builtin(),
            kinds: Kinds::builtin(),
            tracers: Tracers::builtin(),
            library: Library::builtin(),
        }
    }
}

impl Default for Registry {
    fn default() -> Registry {
        Registry::builtin()
    }
}
