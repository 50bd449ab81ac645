//! Effects held against a path tracer: what each storage format costs, and how wrong it is.

mod cell;
mod folder;
mod measure;
mod report;
pub mod suite;
mod sweep;
mod truth;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use voxlume_report::{Bound, Results};

use crate::{Error, Progress, Settings};

/// What to compare: a cell for each scene, effect, format, encoding and resolution.
pub struct Sweep<'a> {
    /// The pipeline whose effects are compared, and what it is measured in.
    pub settings: Settings<'a>,
    /// Scene files: `.ron`, `.gltf` or `.glb`.
    pub scenes: Vec<PathBuf>,
    /// Camera of every scene; the first one if `None`.
    pub camera: Option<String>,
    /// Effects, or `all` that a scene has.
    pub effects: Vec<String>,
    /// The reference's samples of each pixel, at least 2.
    pub samples: u32,
    /// Frames to time, after one of warm-up.
    pub repeat: u32,
    /// What the report marks where it is exceeded.
    pub bounds: Vec<Bound>,
    /// Folder for results, pictures and references. A cell that is finished there under the same settings isn't run again.
    pub folder: PathBuf,
}

impl Sweep<'_> {
    /// Runs all cells, and writes `results.json`, `results.csv`, `report.html` and `images/` into the folder. A cell that
    /// fails has its fault in the results.
    ///
    /// # Errors
    /// A scene, the pipeline or a word is at fault; there is no device; the folder can't be written; `stop` was raised.
    pub fn run(&self, progress: &mut dyn Progress, stop: &AtomicBool) -> Result<Results, Error> {
        sweep::run(self, progress, stop)
    }
}
