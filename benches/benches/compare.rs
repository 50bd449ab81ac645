//! Time and memory against error, by the sweep of `voxlume compare`: `cargo bench -p voxlume-benches --bench compare`.
//!
//! References stay in `target/bench/compare/cache`; everything else is measured anew. `-- --save` makes what it
//! finds the new baseline.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::AtomicBool;

use voxlume::Pipeline;
use voxlume::Registry;
use voxlume_benches::{Stages, enter_repository, remove_folder};
use voxlume_measure::Settings;
use voxlume_measure::compare::Sweep;
use voxlume_report::{Results, against, table};

const FOLDER: &str = "target/bench/compare";
const BASELINE: &str = "benches/baseline.json";

fn main() -> ExitCode {
    let mut save = false;
    for argument in std::env::args().skip(1) {
        match argument.as_str() {
            // Cargo says so to every benchmark.
            "--bench" => {}
            "--save" => save = true,
            other => {
                eprintln!("error: unknown argument `{other}`: --save keeps the figures as the new baseline");
                return ExitCode::from(2);
            }
        }
    }
    match run(save) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(save: bool) -> Result<(), Box<dyn Error>> {
    enter_repository()?;
    // With no finished cell there, all are timed.
    remove_folder(&Path::new(FOLDER).join("cells"))?;
    let baseline = match std::fs::read_to_string(BASELINE) {
        Ok(text) if !save => Some(Results::parse(&text)?),
        _ => None,
    };
    let registry = Registry::builtin();
    let pipeline = Pipeline::builtin("gi")?;
    // What never changes, so that figures of different days can be held against each other.
    let sweep = Sweep {
        settings: Settings {
            registry: &registry,
            pipeline: &pipeline,
            formats: vec!["all".into()],
            encodings: Vec::new(),
            tracers: Vec::new(),
            scales: Vec::new(),
            resolutions: vec![64, 128],
            size: [256, 256],
            adapter: None,
        },
        scenes: ["scenes/cornell.ron", "scenes/lights.ron"].map(Into::into).to_vec(),
        camera: None,
        effects: vec!["all".into()],
        samples: 512,
        repeat: 5,
        bounds: Vec::new(),
        folder: FOLDER.into(),
    };
    let results = sweep.run(&mut Stages, &AtomicBool::new(false))?;
    print!("{}", table(&results));
    let failed = results.failed();
    if failed > 0 {
        return Err(format!("{failed} of {} cells failed", results.rows.len()).into());
    }
    if save {
        std::fs::copy(Path::new(FOLDER).join("results.json"), BASELINE)?;
    }
    if let Some(baseline) = baseline {
        print!("\nsince the baseline:\n{}", against(&results, &baseline));
    }
    Ok(())
}
