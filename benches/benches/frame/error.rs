//! How far an image is from the path tracer's.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use voxlume_benches::{Stages, remove_folder};
use voxlume_measure::Settings;
use voxlume_measure::compare::Sweep;
use voxlume_report::Outcome;

use crate::timed::{Setting, Timer};

const FOLDER: &str = "target/bench/frame";

/// Forgets the images of an earlier run; references are kept.
pub fn forget() -> Result<(), String> {
    let cells = Path::new(FOLDER).join("cells");
    remove_folder(&cells).map_err(|error| format!("cannot remove {}: {error}", cells.display()))
}

/// The root mean square error of `final`, linear radiance.
pub fn rmse(timer: &Timer, scene: &Path, setting: &Setting<'_>) -> Result<f64, String> {
    let Setting { format, tracer, resolution, size } = *setting;
    let sweep = Sweep {
        settings: Settings {
            registry: &timer.registry,
            pipeline: &timer.pipeline,
            formats: vec![format.to_owned()],
            encodings: Vec::new(),
            tracers: vec![tracer.to_owned()],
            resolutions: vec![resolution],
            scales: Vec::new(),
            size,
            adapter: None,
        },
        scenes: vec![scene.to_owned()],
        camera: None,
        effects: vec!["final".to_owned()],
        samples: 512,
        repeat: 1,
        bounds: Vec::new(),
        folder: FOLDER.into(),
    };
    let results = sweep.run(&mut Stages, &AtomicBool::new(false)).map_err(|error| error.to_string())?;
    match results.rows.into_iter().next().map(|row| row.outcome) {
        Some(Outcome::Measured { error, .. }) => Ok(error.rmse),
        Some(Outcome::Failed { fault, .. }) => Err(fault),
        None => Err("the scene shows no `final`".to_owned()),
    }
}
