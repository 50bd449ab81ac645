//! Lights of all kinds over a plane.

use glam::Vec3;
use voxlume_reference::Quantity;
use voxlume_scene::{LightKind, Scene};

use crate::stage::*;

const ALBEDO: f64 = 0.5;

/// A floor point seen from the side, direct light only: radiance is albedo/π × irradiance.
#[track_caller]
fn expect_irradiance(scene: &Scene, point: Vec3, samples: u32, irradiance: f64) {
    let camera = look(point + Vec3::new(0.3, 1.0, 0.2), point);
    expect(scene, &lambert(camera, Quantity::Final { bounces: 0 }, samples), irradiance * ALBEDO / PI);
}

fn lit_floor(kind: LightKind, intensity: f32) -> Scene {
    let mut scene = floor(grey(ALBEDO as f32));
    add_light(&mut scene, kind, intensity);
    scene
}

#[test]
fn a_point_light_falls_off_with_the_square() {
    let scene = lit_floor(LightKind::Point { position: dvec3(1.0, 2.0, 2.0), radius: 0.0 }, 10.0);
    // I cosθ/d² with d = 3, cosθ = 2/3; pixels differ by a thousandth of a radian.
    expect_irradiance(&scene, Vec3::ZERO, 2, 10.0 * 2.0 / 27.0);
}

/// A sphere above the horizon lights a plane as its centre would: E = π L (r/d)² cosθ.
#[test]
fn a_sphere_light_keeps_its_far_field() {
    for radius in [0.01, 0.5, 1.5] {
        let scene = lit_floor(LightKind::Point { position: dvec3(1.0, 2.0, 2.0), radius }, 10.0);
        expect_irradiance(&scene, Vec3::ZERO, 500, 10.0 * 2.0 / 27.0);
    }
}

/// Half of a sphere of angular radius σ centred on the horizon: E = L (σ − sinσ cosσ).
#[test]
fn a_sphere_light_sinks_below_the_horizon() {
    let scene = lit_floor(LightKind::Point { position: dvec3(4.0, 0.0, 0.0), radius: 2.0 }, 10.0);
    let radiance = 10.0 / (PI * 4.0);
    let sigma = 0.5f64.asin();
    expect_irradiance(&scene, Vec3::ZERO, 2000, radiance * (sigma - sigma.sin() * sigma.cos()));
}

#[test]
fn within_a_sphere_light_it_is_dark() {
    let scene = lit_floor(LightKind::Point { position: dvec3(0.5, 0.0, 0.0), radius: 2.0 }, 10.0);
    let camera = look(Vec3::Y, Vec3::ZERO);
    assert_eq!(measure(&scene, &lambert(camera, Quantity::Final { bounces: 0 }, 2)), (0.0, 0.0));
}

#[test]
fn a_directional_disc_keeps_its_irradiance() {
    let direction = Vec3::new(0.0, -0.8, 0.6);
    for degrees in [0.0f32, 0.5, 20.0, 60.0] {
        let angular_diameter = degrees.to_radians();
        let scene = lit_floor(LightKind::Directional { direction, angular_diameter }, 3.0);
        expect_irradiance(&scene, Vec3::ZERO, 500, 3.0 * 0.8);
    }
}

#[test]
fn a_spot_fades_between_its_angles() {
    let (inner, outer) = (0.3f32, 0.6f32);
    for radius in [0.0, 0.2] {
        let position = dvec3(0.0, 2.0, 0.0);
        let kind = LightKind::Spot { position, direction: Vec3::NEG_Y, radius, inner, outer };
        let scene = lit_floor(kind, 8.0);
        for angle in [0.0f64, 0.25, 0.4, 0.5, 0.7] {
            let cos = angle.cos();
            let (full, none) = (f64::from(inner).cos(), f64::from(outer).cos());
            let fade = ((cos - none) / (full - none)).clamp(0.0, 1.0).powi(2);
            let point = Vec3::new(2.0 * angle.tan() as f32, 0.0, 0.0);
            let expected = fade * 8.0 * cos.powi(3) / 4.0;
            if fade == 0.0 {
                let camera = look(point + Vec3::Y, point);
                let request = lambert(camera, Quantity::Final { bounces: 0 }, 2);
                assert_eq!(measure(&scene, &request), (0.0, 0.0));
                // Nor is it seen from there, though nothing stands in between.
                let seen = lambert(look(point + Vec3::Y, point), Quantity::SoftShadow { light: 0 }, 2);
                assert_eq!(measure(&scene, &seen), (0.0, 0.0));
            } else {
                // The fade's slope over a pixel's footprint.
                let camera = look(point + Vec3::new(0.3, 1.0, 0.2), point);
                let request = lambert(camera, Quantity::Final { bounces: 0 }, 200);
                let (mean, error) = measure(&scene, &request);
                let radiance = expected * ALBEDO / PI;
                assert!(
                    (mean - radiance).abs() < 3.0 * error + 1e-3 * radiance,
                    "{angle}: {mean} {radiance}"
                );
            }
        }
    }
}

/// E = π L sin²θ on the axis of a disc that subtends the half-angle θ.
#[test]
fn a_disc_emitter_over_a_plane() {
    for (radius, height) in [(0.2f32, 2.0f32), (1.0, 1.0), (5.0, 0.5)] {
        let mut scene = floor(grey(ALBEDO as f32));
        add_disc(&mut scene, emissive(4.0), Vec3::new(0.0, height, 0.0), radius, false);
        let sin2 = f64::from(radius * radius / (radius * radius + height * height));
        let camera = look(Vec3::new(0.3, height * 0.9, 0.2), Vec3::ZERO);
        let (mean, error) = measure(&scene, &lambert(camera, Quantity::Final { bounces: 0 }, 1000));
        // 256 corners lack 10⁻⁴ of the disc's area.
        let expected = ALBEDO * 4.0 * sin2;
        assert!(error < 0.005 * expected, "{mean} {error}");
        assert!((mean - expected).abs() < 3.0 * error + 2e-4 * expected, "{mean} {error} {expected}");
    }
}

#[test]
fn the_back_of_an_emitter_is_dark_unless_it_is_double_sided() {
    let camera = look(Vec3::new(0.3, 0.9, 0.2), Vec3::ZERO);
    let request = lambert(camera, Quantity::Final { bounces: 2 }, 200);
    for double_sided in [false, true] {
        let mut scene = floor(grey(ALBEDO as f32));
        let mut material = emissive(4.0);
        material.double_sided = double_sided;
        add_disc(&mut scene, material, Vec3::Y, 1.0, true);
        if double_sided {
            let (mean, error) = measure(&scene, &request);
            assert!((mean - ALBEDO * 2.0).abs() < 3.0 * error + 1e-3, "{mean} {error}");
        } else {
            assert_eq!(measure(&scene, &request), (0.0, 0.0));
        }
    }
}

/// Two emitters of very different size and radiance, and a lamp, add up.
#[test]
fn lights_add_up() {
    let mut scene = floor(grey(ALBEDO as f32));
    add_disc(&mut scene, emissive(4.0), Vec3::new(0.0, 1.0, 0.0), 0.5, false);
    add_disc(&mut scene, emissive(900.0), Vec3::new(0.0, 0.5, 0.0), 0.01, false);
    let big = 4.0 * (0.25 / 1.25 - 0.0004 / 1.0004);
    let small = 900.0 * (0.0001 / 0.2501);
    add_light(&mut scene, LightKind::Point { position: dvec3(1.0, 2.0, 2.0), radius: 0.1 }, 3.0);
    let lamp = 3.0 * 2.0 / 27.0 / PI;
    let camera = look(Vec3::new(0.3, 0.4, 0.2), Vec3::ZERO);
    let (mean, error) = measure(&scene, &lambert(camera, Quantity::Final { bounces: 0 }, 1000));
    let expected = ALBEDO * (big + small + lamp);
    assert!(error < 0.005 * expected);
    assert!((mean - expected).abs() < 3.0 * error + 2e-4 * expected, "{mean} {error} {expected}");
}
