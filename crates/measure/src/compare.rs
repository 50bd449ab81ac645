//! Effects held against a path tracer: what each storage format costs, and how wrong it is.

mod cell;
mod folder;
mod measure;
mod report;
mod sweep;
mod truth;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use voxlume::{Pipeline, Registry};
use voxlume_report::Results;

use crate::{Error, Progress};

/// What to compare: a cell for each scene, effect, format, encoding and resolution.
pub struct Sweep<'a> {
    /// Formats and WGSL modules that there are.
    pub registry: &'a Registry,
    /// The pipeline whose effects are compared.
    pub pipeline: &'a Pipeline,
    /// Scene files: `.ron`, `.gltf` or `.glb`.
    pub scenes: Vec<PathBuf>,
    /// Camera of every scene; the first one if `None`.
    pub camera: Option<String>,
    /// Storage formats, or `all`.
    pub formats: Vec<String>,
    /// Tracer of passes that name none; the pipeline's if `None`.
    pub tracer: Option<String>,
    /// Texel encodings, or `all`; the pipeline's if there are none.
    pub encodings: Vec<String>,
    /// Voxels along the grid's longest side.
    pub resolutions: Vec<u32>,
    /// Effects, or `all` that a scene has.
    pub effects: Vec<String>,
    /// Width and height of the images in pixels.
    pub size: [u32; 2],
    /// The reference's samples of each pixel, at least 2.
    pub samples: u32,
    /// Frames to time, after one of warm-up.
    pub repeat: u32,
    /// Part of the name of the graphics device; any if `None`.
    pub adapter: Option<String>,
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
