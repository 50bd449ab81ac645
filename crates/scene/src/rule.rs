//! What is asked of the numbers of materials, lights and cameras, each rule once: a loader says where in its file one is
//! broken, [`Scene::check`](crate::Scene::check) in which part of the scene.

use std::f32::consts::{FRAC_PI_2, PI};

use glam::{Vec3, Vec4};

/// How far from 1 the squared length of a unit vector may be: `f32`'s rounding of a few operations, with room.
pub(crate) const UNIT: f32 = 1e-3;

/// What a value must be, and how a message says so.
pub(crate) type Rule<T> = (fn(T) -> bool, &'static str);

/// Of metallic and roughness.
pub(crate) const SHARE: Rule<f32> = (is_share, "from 0 to 1");
/// Of a base colour and its alpha.
pub(crate) const REFLECTANCE: Rule<Vec4> = (|v| v.to_array().into_iter().all(is_share), "from 0 to 1");
/// Of light: intensity, irradiance, radiance.
pub(crate) const LIGHT: Rule<Vec3> = (|v| v.is_finite() && v.min_element() >= 0.0, "finite and at least 0");
/// Of a radius and an alpha cutoff.
pub(crate) const SIZE: Rule<f32> = (|v| v.is_finite() && v >= 0.0, "finite and at least 0");
/// Of a normal map's scale.
pub(crate) const FINITE: Rule<f32> = (f32::is_finite, "finite");
/// Of a direction.
pub(crate) const DIRECTION: Rule<Vec3> = (|v| (v.length_squared() - 1.0).abs() < UNIT, "of length 1");
/// Of a far light's full angle, in radians.
pub(crate) const ANGULAR_DIAMETER: Rule<f32> = (|v| (0.0..PI).contains(&v), "at least 0° and below 180°");
/// Of a camera's full angle, in radians.
pub(crate) const VERTICAL_FOV: Rule<f32> = (|v| 0.0 < v && v < PI, "above 0° and below 180°");

fn is_share(number: f32) -> bool {
    (0.0..=1.0).contains(&number)
}

/// Whether `value` keeps to a rule; else the message, with the value's name in it.
pub(crate) fn check<T>(
    (good, range): (impl Fn(T) -> bool, &str),
    name: &str,
    value: T,
) -> Result<(), String> {
    if good(value) { Ok(()) } else { Err(format!("{name} must be {range}")) }
}

/// A spot light's inner and outer half-angles in radians.
pub(crate) fn check_spot(inner: f32, outer: f32) -> Result<(), String> {
    check((|v| 0.0 < v && v <= FRAC_PI_2, "above 0° and at most 90°"), "the outer angle", outer)?;
    // The falloff divides by the difference of their cosines.
    check((|v| 0.0 <= v && v < outer, "at least 0° and below the outer angle"), "the inner angle", inner)
}

/// A spot light's half-angles as a file gives them, which may be equal, and round to just above a right angle.
pub(crate) fn spot(inner: f32, outer: f32) -> Result<(f32, f32), String> {
    let outer = if outer <= FRAC_PI_2 * (1.0 + 1e-6) { outer.min(FRAC_PI_2) } else { outer };
    let inner = if inner <= outer { inner.min(outer * 0.999) } else { inner };
    check_spot(inner, outer)?;
    Ok((inner, outer))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// RON gives angles in degrees: the limit itself is refused there as well.
    #[test]
    fn half_a_turn_in_degrees_is_no_angle_of_view() {
        assert!(!VERTICAL_FOV.0(180f32.to_radians()) && VERTICAL_FOV.0(179.999f32.to_radians()));
    }

    #[test]
    fn spot_angles_of_files_are_made_to_differ() {
        assert_eq!(spot(0.5, 0.5).unwrap(), (0.4995, 0.5));
        assert_eq!(spot(0.0, 90f32.to_radians()).unwrap().1, FRAC_PI_2);
        for (inner, outer) in
            [(0.6, 0.5), (-0.1, 0.5), (0.0, 0.0), (0.0, 1.6), (f32::NAN, 0.5), (0.0, f32::NAN)]
        {
            assert!(spot(inner, outer).is_err(), "{inner} {outer}");
        }
        assert!(check_spot(0.5, 0.5).is_err());
    }
}
