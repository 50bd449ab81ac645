//! `voxlume devices`.

use voxlume::wgpu::{AdapterInfo, DeviceType};
use voxlume::{Error, Gpu};
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
        table.row([info.name.clone(), kind(info).into(), info.backend.to_string(), clock, driver(info)]);
    }
    crate::print(&table.to_string())
}

/// What results say of a device.
pub fn describe(info: &AdapterInfo) -> Device {
    Device { name: info.name.clone(), kind: kind(info).to_owned(), driver: driver(info) }
}

/// What sort of device it is, in words.
fn kind(info: &AdapterInfo) -> &'static str {
    match info.device_type {
        DeviceType::Cpu => "software device",
        DeviceType::DiscreteGpu => "discrete GPU",
        DeviceType::IntegratedGpu => "integrated GPU",
        DeviceType::VirtualGpu => "virtual GPU",
        DeviceType::Other => "unknown type",
    }
}

/// The driver's name and version.
fn driver(info: &AdapterInfo) -> String {
    format!("{} {}", info.driver, info.driver_info).trim().to_owned()
}
