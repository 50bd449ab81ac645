//! What an encoding makes of a number.

use glam::DVec4;
use voxlume::Encoding;

/// A unit in the last place over the value: Vulkan lets a store round to the nearest number or towards zero, and
/// llvmpipe does the latter.
pub fn relative_rounding(encoding: Encoding) -> f64 {
    match encoding {
        Encoding::Rgba8 { .. } => 0.0,
        // 11 and 24 bits of precision.
        Encoding::Rgba16Float => (-10f64).exp2(),
        Encoding::Rgba32Float => (-23f64).exp2(),
    }
}

/// The distance of the smallest numbers of each channel.
pub fn absolute_rounding(encoding: Encoding, signed: bool) -> DVec4 {
    match encoding {
        Encoding::Rgba8 { range } => {
            DVec4::splat(f64::from(range)).with_w(1.0) / if signed { 127.0 } else { 255.0 }
        }
        // Subnormals; of single precision they may be flushed.
        Encoding::Rgba16Float => DVec4::splat((-24f64).exp2()),
        Encoding::Rgba32Float => DVec4::splat((-126f64).exp2()),
    }
}

/// What is left of a number beyond the encoding's range.
pub fn clamped(encoding: Encoding, value: DVec4) -> DVec4 {
    let range = DVec4::splat(f64::from(encoding.range()));
    let range = if matches!(encoding, Encoding::Rgba8 { .. }) { range.with_w(1.0) } else { range };
    value.clamp(-range, range)
}
