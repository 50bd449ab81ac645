//! What a surface reflects of even light: wgsl/common/reflectance.wgsl in `f64`.

use glam::DVec3;

/// What a surface of glTF's metallic-roughness model reflects of even light from all sides to all sides: base colour and
/// metallic in \[0, 1\], roughness perceptual, in \[0, 1\].
pub fn total_reflectance(base_color: DVec3, metallic: f64, roughness: f64) -> DVec3 {
    let r = roughness;
    let whole = 1.0 + r * (-0.0173 + r * (0.3521 + r * (-2.2374 + r * 1.3139)));
    let grazing = 0.0469 + r * (0.0426 + r * (-0.4189 + r * (0.5558 - r * 0.224)));
    let f0 = DVec3::splat(0.04).lerp(base_color, metallic);
    0.9564 * (1.0 - metallic) * base_color + grazing + (whole - grazing) * f0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the integral: the mean over cosine-weighted directions in and out, by the midpoint rule.
    #[test]
    fn it_is_the_integral() {
        const N: usize = 40;
        let mean = |base: f64, metallic: f64, roughness: f64| {
            let alpha = roughness * roughness;
            let f0 = 0.04 + (base - 0.04) * metallic;
            let mut sum = 0.0;
            let at = |i: usize| (i as f64 + 0.5) / N as f64;
            for (i, j, k) in (0..N * N * N).map(|n| (n % N, n / N % N, n / (N * N))) {
                let (vz, lz, angle) = (at(i).sqrt(), at(j).sqrt(), at(k) * std::f64::consts::PI);
                let (vr, lr) = ((1.0 - vz * vz).sqrt(), (1.0 - lz * lz).sqrt());
                let (v, l) = (DVec3::new(vr, 0.0, vz), DVec3::new(lr * angle.cos(), lr * angle.sin(), lz));
                let h = (v + l).normalize();
                let fresnel = |f0: f64| f0 + (1.0 - f0) * (1.0 - v.dot(h)).powi(5);
                let a2 = alpha * alpha;
                let d = a2 / (std::f64::consts::PI * (h.z * h.z * (a2 - 1.0) + 1.0).powi(2));
                let smith = |a: f64, b: f64| a * (b * b * (1.0 - a2) + a2).sqrt();
                let lobe = fresnel(f0) * d * 0.5 / (smith(lz, vz) + smith(vz, lz)) * std::f64::consts::PI;
                sum += (1.0 - fresnel(0.04)) * base * (1.0 - metallic) + lobe;
            }
            sum / (N * N * N) as f64
        };
        for (base, metallic, roughness) in [
            (0.73, 0.0, 1.0),
            (0.73, 0.0, 0.6),
            (0.9, 1.0, 1.0),
            (0.9, 1.0, 0.6),
            (0.5, 0.5, 0.8),
            (0.0, 0.0, 1.0),
        ] {
            let (is, expected) = (
                total_reflectance(DVec3::splat(base), metallic, roughness).x,
                mean(base, metallic, roughness),
            );
            // The polynomials' error, and the rule's.
            assert!((is - expected).abs() < 0.004, "{base} {metallic} {roughness}: {is}, not {expected}");
        }
    }
}
