//! From linear radiance to what a screen shows.

/// Luminance that becomes 1.
const WHITE: f32 = 4.0;

/// Reinhard et al., "Photographic Tone Reproduction for Digital Images", 2002, eq. 4, on luminance with a white
/// point of 4: dark colours stay as they are, bright ones are compressed, hues keep until a channel leaves
/// the screen's range. Takes linear RGB of Rec. 709, gives values in [0, 1].
pub fn reinhard(color: [f32; 3]) -> [f32; 3] {
    // A NaN becomes 0; infinity, the most that images of half floats hold.
    let color = color.map(|c| if c > 0.0 { c.min(65504.0) } else { 0.0 });
    let luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    let scale = (1.0 + luminance / (WHITE * WHITE)) / (1.0 + luminance);
    color.map(|c| (c * scale).min(1.0))
}

/// The sRGB transfer function (IEC 61966-2-1), for values in [0, 1].
pub fn srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: [f32; 3], b: [f32; 3]) {
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-5), "{a:?} is not {b:?}");
    }

    #[test]
    fn values_on_paper() {
        close(reinhard([0.0; 3]), [0.0; 3]);
        close(reinhard([0.001; 3]), [0.000_999; 3]);
        // 1 · (1 + 1/16) / 2
        close(reinhard([1.0; 3]), [0.531_25; 3]);
        close(reinhard([4.0; 3]), [1.0; 3]);
        // The ratio of channels stays: luminance 0.2126, so (1 + 0.2126/16) / 1.2126.
        close(reinhard([1.0, 0.0, 0.0]), [0.835_632, 0.0, 0.0]);
    }

    #[test]
    fn nothing_leaves_the_range() {
        for value in [f32::NAN, f32::INFINITY, -1.0, 1e30, 65504.0, 1.0] {
            let mapped = reinhard([value, 0.1, 3.0]);
            assert!(mapped.iter().all(|c| (0.0..=1.0).contains(c)), "{value}: {mapped:?}");
        }
    }

    #[test]
    fn srgb_is_the_standards() {
        close([srgb(0.0), srgb(1.0), srgb(0.214_041_14)], [0.0, 1.0, 0.5]);
        close([srgb(0.003), 0.0, 0.0], [0.03876, 0.0, 0.0]);
    }
}
