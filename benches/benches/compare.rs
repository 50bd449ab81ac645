//! Time and memory against error, with `voxlume compare`'s own harness: `cargo bench -p voxlume-benches --bench compare`.
//!
//! References stay in `target/bench/compare/cache`; everything else is measured anew. `-- --save` makes what it
//! finds the new baseline.

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use voxlume_cli::{Registry, main_with};

/// What never changes, so that figures of different days can be held against each other.
const SWEEP: [&str; 9] = [
    "compare",
    "scenes/cornell.ron",
    "scenes/lights.ron",
    "--formats=all",
    "--resolutions=64,128",
    "--size=256x256",
    "--spp=512",
    "--repeat=5",
    "--out=target/bench/compare",
];
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
    let done = prepare().map(|()| main_with(&Registry::builtin(), arguments(save)));
    match done {
        Ok(code) if code == ExitCode::SUCCESS && save => {
            match std::fs::copy("target/bench/compare/results.json", BASELINE) {
                Ok(_) => code,
                Err(error) => failed(&error),
            }
        }
        Ok(code) => code,
        Err(error) => failed(&error),
    }
}

fn failed(error: &std::io::Error) -> ExitCode {
    eprintln!("error: {error}");
    ExitCode::FAILURE
}

/// To the workspace's root, and no finished cell there, so that all are timed.
fn prepare() -> std::io::Result<()> {
    std::env::set_current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))?;
    match std::fs::remove_dir_all("target/bench/compare/cells") {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

fn arguments(save: bool) -> Vec<OsString> {
    let baseline = !save && Path::new(BASELINE).exists();
    let with = baseline.then(|| format!("--baseline={BASELINE}"));
    ["voxlume"].iter().chain(&SWEEP).map(OsString::from).chain(with.map(OsString::from)).collect()
}
