//! What an encoding makes of a number.

use glam::DVec4;
use voxlume::{Encoding, Numbers, Texel};

/// A unit in the last place over the value: Vulkan lets a store round to the nearest number or towards zero, and
/// llvmpipe does the latter.
pub fn relative_rounding(encoding: Encoding, numbers: Numbers) -> f64 {
    match numbers.texel(encoding) {
        Texel::Rgba8Unorm | Texel::Rgba8Snorm => 0.0,
        // 24 and 11 bits of precision.
        Texel::Rgba32Float => (-23f64).exp2(),
        Texel::Rgba16Float => (-10f64).exp2(),
    }
}

/// The distance of the smallest numbers of each channel.
pub fn absolute_rounding(encoding: Encoding, numbers: Numbers) -> DVec4 {
    match numbers.texel(encoding) {
        Texel::Rgba8Unorm => ranges(encoding, numbers) / 255.0,
        Texel::Rgba8Snorm => ranges(encoding, numbers) / 127.0,
        // Subnormals; of single precision they may be flushed.
        Texel::Rgba32Float => DVec4::splat((-126f64).exp2()),
        Texel::Rgba16Float => DVec4::splat((-24f64).exp2()),
    }
}

/// Whether each number is a byte.
pub fn are_bytes(encoding: Encoding, numbers: Numbers) -> bool {
    matches!(numbers.texel(encoding), Texel::Rgba8Unorm | Texel::Rgba8Snorm)
}

/// What is left of a number beyond the encoding's range.
pub fn clamped(encoding: Encoding, numbers: Numbers, value: DVec4) -> DVec4 {
    let range = ranges(encoding, numbers);
    value.clamp(-range, range)
}

fn ranges(encoding: Encoding, numbers: Numbers) -> DVec4 {
    DVec4::from_array(numbers.ranges(encoding).map(f64::from))
}
