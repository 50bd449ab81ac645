//! What a frame costs: `cargo bench -p voxlume-benches --bench frame`; `-- --help` says what its arguments select.

mod against;
mod arguments;
mod error;
mod frames;
mod growth;
mod scenes;
mod timed;

use std::process::ExitCode;

use clap::Parser;
use voxlume::{Gpu, Pipeline, Registry};
use voxlume_benches::enter_repository;

use crate::arguments::Arguments;
use crate::growth::Growth;
use crate::timed::Timer;

fn main() -> ExitCode {
    // Before scenes are looked for.
    if let Err(error) = enter_repository() {
        eprintln!("error: {error}");
        return ExitCode::FAILURE;
    }
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let gpu = Gpu::open(None).map_err(|error| error.to_string())?;
    println!("{} ({})\n", gpu.info.name, gpu.info.driver_info);
    if let Some(other) = &arguments.against {
        against::table(arguments, other, &gpu.info.name)?;
        println!();
    }
    let tables = arguments.tables();
    if tables.is_empty() {
        return Ok(());
    }
    println!(
        "Milliseconds of all passes that a frame runs, median ± half of the interquartile range; {} frames after one of warm-up.\n",
        arguments.repeat
    );
    let pipeline = Pipeline::builtin("gi").map_err(|faults| faults.to_string())?;
    let timer = Timer { gpu, pipeline, registry: Registry::builtin(), repeat: arguments.repeat };
    for table in tables {
        match Growth::of(table) {
            None => frames::table(&timer, arguments)?,
            Some(growth) => growth.table(&timer, arguments)?,
        }
        println!();
    }
    Ok(())
}
