//! The GGX microfacet distribution, isotropic, in the local frame where the normal is +z.
//!
//! Walter et al. 2007 eq. 33 (D), Heitz 2014 eq. 72 and 99 (Smith, height-correlated).

use glam::Vec3;

use std::f32::consts::PI;

/// Distribution of normals D(h), sr⁻¹. Written with h's sine, so that a narrow lobe keeps its digits.
pub(crate) fn distribution(half: Vec3, alpha: f32) -> f32 {
    let slope = (half.x * half.x + half.y * half.y) / (alpha * alpha) + half.z * half.z;
    1.0 / (PI * alpha * alpha * slope * slope)
}

/// G₂ / (4 cosθₒ cosθᵢ): height-correlated Smith masking and shadowing over the BRDF's denominator.
pub(crate) fn visibility(cos_o: f32, cos_i: f32, alpha: f32) -> f32 {
    0.5 / (cos_i * lambda_root(cos_o, alpha) + cos_o * lambda_root(cos_i, alpha))
}

/// Density, per solid angle, of the mirror directions about visible normals: G₁ D / (4 cosθₒ).
pub(crate) fn mirror_pdf(cos_o: f32, half: Vec3, alpha: f32) -> f32 {
    distribution(half, alpha) / (2.0 * (cos_o + lambda_root(cos_o, alpha)))
}

fn lambda_root(cos: f32, alpha: f32) -> f32 {
    (alpha * alpha + (1.0 - alpha * alpha) * cos * cos).sqrt()
}

/// The mirror direction of `out` about a visible normal (Dupuy and Benyoub 2023, "Sampling Visible
/// GGX Normals with Spherical Caps"). It may point below the surface.
pub(crate) fn sample_mirror(out: Vec3, alpha: f32, [u, v]: [f32; 2]) -> Vec3 {
    let stretched = Vec3::new(out.x * alpha, out.y * alpha, out.z).normalize();
    let (sin_phi, cos_phi) = (2.0 * PI * u).sin_cos();
    let z = (1.0 - v) * (1.0 + stretched.z) - stretched.z;
    let sin = (1.0 - z * z).max(0.0).sqrt();
    let half = Vec3::new(sin * cos_phi, sin * sin_phi, z) + stretched;
    let half = Vec3::new(half.x * alpha, half.y * alpha, half.z).normalize_or(Vec3::Z);
    2.0 * out.dot(half) * half - out
}

/// Fresnel reflectance after Schlick, `cos` between the direction and the half vector.
pub(crate) fn schlick(f0: Vec3, cos: f32) -> Vec3 {
    f0 + (Vec3::ONE - f0) * (1.0 - cos).clamp(0.0, 1.0).powi(5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn direction(theta: f64, phi: f64) -> Vec3 {
        Vec3::new((theta.sin() * phi.cos()) as f32, (theta.sin() * phi.sin()) as f32, theta.cos() as f32)
    }

    /// ∫ f dω over the polar angles below `limit` by the midpoint rule.
    fn integrate(limit: f64, f: impl Fn(Vec3) -> f32) -> f64 {
        let (rows, columns) = (600, 300);
        let (dt, dp) = (limit / f64::from(rows), std::f64::consts::TAU / f64::from(columns));
        let cell = |i: i32, j: i32| {
            let theta = (f64::from(i) + 0.5) * dt;
            f64::from(f(direction(theta, (f64::from(j) + 0.5) * dp))) * theta.sin() * dt * dp
        };
        (0..rows).flat_map(|i| (0..columns).map(move |j| cell(i, j))).sum()
    }

    #[test]
    fn the_distribution_projects_to_one() {
        for alpha in [0.05, 0.3, 1.0] {
            let area = integrate(std::f64::consts::FRAC_PI_2, |h| distribution(h, alpha) * h.z);
            assert!((area - 1.0).abs() < 2e-3, "{alpha}: {area}");
        }
    }

    #[test]
    fn mirror_directions_follow_their_density() {
        let out = direction(1.0, 0.4);
        for alpha in [0.1, 0.5, 1.0] {
            // Visible normals point up.
            let pdf = |i: Vec3| match (out + i).normalize() {
                half if half.z > 0.0 => mirror_pdf(out.z, half, alpha),
                _ => 0.0,
            };
            let total = integrate(std::f64::consts::PI, pdf);
            assert!((total - 1.0).abs() < 5e-3, "{alpha}: {total}");
            let expected = [0, 1, 2].map(|k| integrate(std::f64::consts::PI, |i| pdf(i) * i[k]));
            let mut rng = Rng::new(3, 0, 0);
            let samples = 40_000;
            let sum: Vec3 = (0..samples).map(|_| sample_mirror(out, alpha, rng.square())).sum();
            for k in 0..3 {
                let mean = f64::from(sum[k]) / f64::from(samples);
                assert!((mean - expected[k]).abs() < 0.012, "{alpha} {k}: {mean} {}", expected[k]);
            }
        }
    }
}
