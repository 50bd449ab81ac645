//! Hard cases: small scenes that break renderers, each with a property that should hold and figures that say how far it does.

mod bench;
mod cases;
mod figure;
mod misses;
mod sweep;

use std::sync::atomic::AtomicBool;

use voxlume_report::Stability;

use crate::{Error, Progress, Settings};

pub use cases::Case;
pub use sweep::all as cases;

/// What to run: a cell for each case, format, encoding and resolution.
pub struct Suite<'a> {
    /// The pipeline `gi`, whose passes and images the cases name, and what it is measured in; without resolutions in each
    /// case's own.
    pub settings: Settings<'a>,
    /// Names of cases; all if there are none.
    pub cases: Vec<String>,
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
