//! A suite for every storage format and one for every tracer, from this workspace or from outside.
//!
//! [`run`] fills small grids with voxels, has a device store, filter and sample them with the format's own WGSL, and
//! measures eight properties and, where the format has a CPU twin, the difference to it. Each figure has a bound that
//! follows from the encoding's rounding. What a format can't hold by nature it declares with its size
//! ([`StorageFormat::misses`]); then the figure is held to that, and a declaration that isn't needed fails.
//!
//! ```no_run
//! use voxlume::{Encoding, Gpu, Library, twin, Isotropic};
//!
//! let gpu = Gpu::open(None)?;
//! let report = voxlume_conformance::run(&gpu, &Isotropic, &Library::builtin(), Encoding::RGBA16FLOAT)?;
//! println!("{report}");
//! assert!(report.passes());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`run_tracer`] measures a tracer on scenes whose answers are known; what its figures may be is the caller's to say.

mod against_twin;
mod bench;
mod content;
mod directions;
mod property;
mod report;
mod rounding;
mod substrate;
mod symmetry;
mod tracer;

use voxlume::{Choices, Encoding, Faults, Gpu, Library, StorageFormat};

pub use against_twin::against_twin;
pub use bench::{Bench, Probe};
pub use content::{Content, Voxel};
pub use directions::directions;
pub use report::{Check, Report};
pub use rounding::{absolute_rounding, are_bytes, clamped, relative_rounding};
pub use symmetry::Symmetry;
pub use tracer::{TracerFigure, run_tracer};

/// Why the suite can't run.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The shaders are at fault.
    #[error("{0}")]
    Shaders(#[from] Faults),
    /// The device fails.
    #[error("{0}")]
    Device(#[from] voxlume::Error),
}

/// Voxels along the suite's grids.
pub const SIDE: u32 = 8;

/// Runs the whole suite on a format with its default choices.
///
/// # Errors
/// The format's shaders are at fault, or the device fails. A property that doesn't hold is no error but in the report.
pub fn run(
    gpu: &Gpu,
    format: &dyn StorageFormat,
    library: &Library,
    encoding: Encoding,
) -> Result<Report, Error> {
    let choices = Choices::default();
    let mut bench = Bench::new(gpu, format, &choices, library, encoding, SIDE)?;
    let mut report = Report::new(format, encoding);
    property::measure(&mut bench, &mut report)?;
    if let Some(twin) = format.twin(&choices) {
        for (name, content) in Content::adversarial(SIDE) {
            report.extend(against_twin(&mut bench, twin.as_ref(), name, &content)?);
        }
    }
    Ok(report)
}
