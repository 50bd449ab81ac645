//! Directions and frames.

use glam::Vec3;

use std::f32::consts::PI;

/// An orthonormal basis around a shading normal.
#[derive(Clone, Copy)]
pub(crate) struct Frame {
    tangent: Vec3,
    bitangent: Vec3,
    pub(crate) normal: Vec3,
}

impl Frame {
    /// A basis around the unit vector `normal`.
    pub(crate) fn new(normal: Vec3) -> Self {
        let (tangent, bitangent) = normal.any_orthonormal_pair();
        Frame { tangent, bitangent, normal }
    }

    pub(crate) fn to_world(self, v: Vec3) -> Vec3 {
        self.tangent * v.x + self.bitangent * v.y + self.normal * v.z
    }

    pub(crate) fn to_local(self, v: Vec3) -> Vec3 {
        Vec3::new(self.tangent.dot(v), self.bitangent.dot(v), self.normal.dot(v))
    }
}

/// A direction around +z with density cosθ/π.
pub(crate) fn cosine_hemisphere([u, v]: [f32; 2]) -> Vec3 {
    let (sin, cos) = (2.0 * PI * v).sin_cos();
    let radius = u.sqrt();
    Vec3::new(radius * cos, radius * sin, (1.0 - u).sqrt())
}

/// Directions that an extended light subtends: a circular cone.
#[derive(Clone, Copy)]
pub(crate) struct Cone {
    /// Towards the light's centre, unit.
    pub(crate) axis: Vec3,
    /// Squared sine of the half-angle, which is below π/2.
    pub(crate) sin2: f32,
}

impl Cone {
    /// 1 − cos of the half-angle, without cancellation for narrow cones.
    fn height(self) -> f32 {
        self.sin2 / (1.0 + (1.0 - self.sin2).sqrt())
    }

    /// Uniform density over the cone, sr⁻¹.
    pub(crate) fn pdf(self) -> f32 {
        1.0 / (2.0 * PI * self.height())
    }

    /// A direction with that density, unit.
    pub(crate) fn sample(self, [u, v]: [f32; 2]) -> Vec3 {
        let height = u * self.height();
        let sin_theta = (height * (2.0 - height)).sqrt();
        let (sin, cos) = (2.0 * PI * v).sin_cos();
        Frame::new(self.axis).to_world(Vec3::new(sin_theta * cos, sin_theta * sin, 1.0 - height))
    }

    /// Whether the unit vector `direction` lies in the cone.
    pub(crate) fn contains(self, direction: Vec3) -> bool {
        self.axis.dot(direction) > 0.0 && self.axis.cross(direction).length_squared() < self.sin2
    }
}

/// The power heuristic's weight (Veach 1997, exponent 2) of a sample of density `own`, which may be
/// infinite, where another technique has density `other`.
pub(crate) fn power_heuristic(own: f32, other: f32) -> f32 {
    if own.is_infinite() {
        return 1.0;
    }
    let ratio = other / own;
    1.0 / (1.0 + ratio * ratio)
}

/// Relative luminance of linear Rec. 709 colours.
pub(crate) fn luminance(rgb: Vec3) -> f32 {
    rgb.dot(Vec3::new(0.2126, 0.7152, 0.0722))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn a_cone_is_sampled_uniformly_within_its_edge() {
        for degrees in [0.01f32, 0.5, 20.0, 89.0] {
            let half = degrees.to_radians();
            let cone = Cone { axis: Vec3::new(0.6, 0.0, 0.8), sin2: half.sin().powi(2) };
            let mut rng = Rng::new(1, 2, 3);
            let samples = 20_000;
            let mut inner = 0;
            for _ in 0..samples {
                let direction = cone.sample(rng.square());
                let sin = f64::from(cone.axis.cross(direction).length());
                assert!(sin <= f64::from(half.sin()) * 1.001 + 1e-6);
                // Half of the solid angle is where 1 − cosθ is below half its maximum.
                let limit = (f64::from(half) / 2.0).sin() / 2f64.sqrt();
                inner += i32::from((sin.asin() / 2.0).sin() < limit);
            }
            let deviation = (f64::from(samples) * 0.25).sqrt();
            assert!(
                (f64::from(inner) - f64::from(samples) / 2.0).abs() < 4.0 * deviation,
                "{degrees}: {inner}"
            );
            let solid_angle = 4.0 * std::f64::consts::PI * (f64::from(half) / 2.0).sin().powi(2);
            assert!((f64::from(cone.pdf()) * solid_angle - 1.0).abs() < 1e-4);
        }
    }

    #[test]
    fn the_power_heuristic_is_a_partition_and_takes_infinite_densities() {
        assert!((power_heuristic(3.0, 4.0) + power_heuristic(4.0, 3.0) - 1.0).abs() < 1e-6);
        assert_eq!(power_heuristic(f32::INFINITY, f32::INFINITY), 1.0);
        assert_eq!(power_heuristic(4.0, f32::INFINITY), 0.0);
        assert_eq!(power_heuristic(4.0, 0.0), 1.0);
    }
}
