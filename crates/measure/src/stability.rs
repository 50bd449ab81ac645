//! Hard cases: small scenes that break renderers, each with a property that should hold and figures that say how far it does.

mod bench;
mod cases;
mod figure;
mod misses;
mod sweep;

use std::sync::atomic::AtomicBool;

use voxlume::{Pipeline, Registry};
use voxlume_report::Stability;

use crate::{Error, Progress};

pub use cases::Case;
pub use sweep::all as cases;

/// What to run: a cell for each case, format, encoding and resolution.
pub struct Suite<'a> {
    /// Formats and WGSL modules that there are.
    pub registry: &'a Registry,
    /// The pipeline `gi`, whose passes and images the cases name.
    pub pipeline: &'a Pipeline,
    /// Names of cases; all if there are none.
    pub cases: Vec<String>,
    /// Storage formats, or `all`.
    pub formats: Vec<String>,
    /// Texel encodings, or `all`.
    pub encodings: Vec<String>,
    /// Voxels along the grid's longest side; each case's own if there are none.
    pub resolutions: Vec<u32>,
    /// Width and height of the images in pixels.
    pub size: [u32; 2],
    /// Part of the name of the graphics device; any if `None`.
    pub adapter: Option<String>,
}

/// What a run gave.
pub struct Ran {
    /// The figures of the finished cells.
    pub stability: Stability,
    /// How many cells are finished.
    pub finished: usize,
    /// How many there are.
    pub all: usize,
}

impl Suite<'_> {
    /// Runs the cases, until `stop` is raised. A case that fails has a row that says so.
    ///
    /// # Errors
    /// A word is unknown; there is no device; the first cell fails by a fault of its input.
    pub fn run(&self, progress: &mut dyn Progress, stop: &AtomicBool) -> Result<Ran, Error> {
        sweep::run(self, progress, stop)
    }
}
