//! `voxlume devices`.

use voxlume::{Error, Gpu};
use voxlume_measure::describe;
use voxlume_report::Device;

use crate::failure::Failure;
use crate::table::Table;

/// List the graphics devices that --adapter and WGPU_ADAPTER_NAME choose from
///
/// Ends with exit code 1, and says what to install, where there is none.
#[derive(clap::Args)]
pub struct Args {}

/// Runs the command.
pub fn run(_: &Args) -> Result<(), Failure> {
    let devices = Gpu::list();
    if devices.is_empty() {
        return Err(Error::NoAdapter.into());
    }
    let mut table = Table::new(["name", "type", "backend", "pass times by", "driver"]);
    for info in &devices {
        let clock = match Gpu::open(Some(&info.name)) {
            Ok(gpu) if gpu.has_reliable_timestamps() => "its timestamps".to_owned(),
            Ok(_) => "the host's clock".to_owned(),
            Err(error) => error.to_string(),
        };
        let Device { name, kind, driver } = describe(info);
        table.row([name, kind, info.backend.to_string(), clock, driver]);
    }
    crate::print(&table.to_string())
}
