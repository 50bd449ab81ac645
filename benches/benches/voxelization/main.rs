//! RAU table 4.1 on this device: `cargo bench -p voxlume-benches --bench voxelization`. The README says what its arguments select.

mod arguments;
mod measure;
mod scenes;
mod table;

use std::process::ExitCode;

use voxlume::Gpu;
use voxlume_benches::enter_repository;

use crate::arguments::{Arguments, CHOICES};

fn main() -> ExitCode {
    let arguments = match Arguments::parse(std::env::args().skip(1)) {
        Ok(arguments) => arguments,
        Err(message) => {
            eprintln!("error: {message}\n{CHOICES}");
            return ExitCode::from(2);
        }
    };
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    enter_repository().map_err(|error| error.to_string())?;
    let gpu = Gpu::open(None).map_err(|error| error.to_string())?;
    let kind = if gpu.info.device_type == voxlume::wgpu::DeviceType::Cpu { "software device" } else { "GPU" };
    println!("{}, {kind}; milliseconds, median of {}\n", gpu.info.name, arguments.repeat);
    table::head(arguments);
    for name in &arguments.scenes {
        let Some(scene) = scenes::load(name)? else {
            println!("{name}: skipped, there is no such file");
            continue;
        };
        for resolution in &arguments.resolutions {
            for separability in &arguments.separabilities {
                for attributes in &arguments.attributes {
                    let mut row = Vec::new();
                    for method in &arguments.methods {
                        row.push(measure::cell(
                            &gpu,
                            &scene,
                            *resolution,
                            separability,
                            *attributes,
                            method,
                            arguments.repeat,
                        )?);
                    }
                    table::row(name, &scene, *resolution, separability, *attributes, &row);
                }
            }
        }
        if arguments.search {
            measure::search_cutoff(&gpu, &scene, arguments)?;
        }
    }
    Ok(())
}
