//! What results say of a device.

use voxlume::wgpu::{AdapterInfo, DeviceType};
use voxlume_report::Device;

/// What results say of a device.
pub fn describe(info: &AdapterInfo) -> Device {
    let kind = match info.device_type {
        DeviceType::Cpu => "software device",
        DeviceType::DiscreteGpu => "discrete GPU",
        DeviceType::IntegratedGpu => "integrated GPU",
        DeviceType::VirtualGpu => "virtual GPU",
        DeviceType::Other => "unknown type",
    };
    let driver = format!("{} {}", info.driver, info.driver_info).trim().to_owned();
    Device { name: info.name.clone(), kind: kind.to_owned(), driver }
}
