//! From linear radiance to what a screen shows.

/// The Khronos PBR Neutral tone mapper (Khronos Group, specification of May 2024): colours below 0.8 keep their
/// hue and, but for 0.04 of Fresnel reflection, their value; what is brighter is compressed and desaturated.
/// Takes linear RGB of Rec. 709, at least 0; gives values in [0, 1].
pub fn khronos_pbr_neutral(color: [f32; 3]) -> [f32; 3] {
    const FRESNEL: f32 = 0.04;
    const START: f32 = 0.8 - FRESNEL;
    const DESATURATION: f32 = 0.15;
    // A NaN becomes 0; infinity, and all that f16 can't hold, its largest value.
    let color = color.map(|c| c.max(0.0).min(65504.0));
    let least = color[0].min(color[1]).min(color[2]);
    let offset = if least < 2.0 * FRESNEL { least - least * least / (4.0 * FRESNEL) } else { FRESNEL };
    let color = color.map(|c| c - offset);
    let peak = color[0].max(color[1]).max(color[2]);
    if peak < START {
        return color;
    }
    let room = 1.0 - START;
    let compressed = 1.0 - room * room / (peak + room - START);
    let grey = 1.0 - 1.0 / (DESATURATION * (peak - compressed) + 1.0);
    color.map(|c| c * compressed / peak * (1.0 - grey) + compressed * grey)
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
    fn values_of_the_specification() {
        close(khronos_pbr_neutral([0.0; 3]), [0.0; 3]);
        // Below 0.08 the least channel becomes 6.25 x².
        close(khronos_pbr_neutral([0.04; 3]), [0.01; 3]);
        close(khronos_pbr_neutral([0.5, 0.3, 0.2]), [0.46, 0.26, 0.16]);
        // Where compression begins: 0.8 gives 0.76.
        close(khronos_pbr_neutral([0.8; 3]), [0.76; 3]);
        // 1 - 0.24² / (3.96 + 0.24 - 0.76)
        close(khronos_pbr_neutral([4.0; 3]), [0.983_255_8; 3]);
    }

    #[test]
    fn nothing_leaves_the_range() {
        for value in [f32::NAN, f32::INFINITY, -1.0, 1e30, 65504.0, 1.0] {
            let mapped = khronos_pbr_neutral([value, 0.1, 3.0]);
            assert!(mapped.iter().all(|c| (0.0..=1.0).contains(c)), "{value}: {mapped:?}");
        }
    }

    #[test]
    fn srgb_is_the_standards() {
        close([srgb(0.0), srgb(1.0), srgb(0.214_041_14)], [0.0, 1.0, 0.5]);
        close([srgb(0.003), 0.0, 0.0], [0.03876, 0.0, 0.0]);
    }
}
