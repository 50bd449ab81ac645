//! What an encoding makes of a number.

use glam::DVec4;
use voxlume::{Encoding, Numbers};

/// A unit in the last place over the value: Vulkan lets a store round to the nearest number or towards zero, and
/// llvmpipe does the latter.
pub fn relative_rounding(encoding: Encoding, numbers: Numbers) -> f64 {
    match encoding {
        _ if numbers.are_bytes(encoding) => 0.0,
        // 24 and 11 bits of precision.
        Encoding::Rgba32Float => (-23f64).exp2(),
        _ => (-10f64).exp2(),
    }
}

/// The distance of the smallest numbers of each channel.
pub fn absolute_rounding(encoding: Encoding, numbers: Numbers) -> DVec4 {
    match encoding {
        _ if numbers.are_bytes(encoding) => {
            ranges(encoding, numbers) / if numbers.are_signed() { 127.0 } else { 255.0 }
        }
        // Subnormals; of single precision they may be flushed.
        Encoding::Rgba32Float => DVec4::splat((-126f64).exp2()),
        _ => DVec4::splat((-24f64).exp2()),
    }
}

/// What is left of a number beyond the encoding's range.
pub fn clamped(encoding: Encoding, numbers: Numbers, value: DVec4) -> DVec4 {
    let range = ranges(encoding, numbers);
    value.clamp(-range, range)
}

fn ranges(encoding: Encoding, numbers: Numbers) -> DVec4 {
    DVec4::from_array(numbers.ranges(encoding).map(f64::from))
}
