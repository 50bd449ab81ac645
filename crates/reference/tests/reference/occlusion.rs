//! Ambient occlusion and soft shadows.

use glam::Vec3;
use voxlume_reference::Quantity;
use voxlume_scene::{LightKind, Scene};

use crate::stage::*;

/// A floor with a wall at x = 1 of the given height, and the floor point at the origin.
fn corner(height: f32) -> Scene {
    let mut scene = floor(grey(0.5));
    let at = |y: f32, z: f32| Vec3::new(1.0, y, z * WIDE);
    let wall = [at(0.0, 1.0), at(height, 1.0), at(height, -1.0), at(0.0, -1.0)];
    add_quads(&mut scene, grey(0.5), &[wall]);
    scene
}

#[track_caller]
fn expect_accessibility(scene: &Scene, distance: f32, falloff: f32, expected: f64) {
    let camera = look(Vec3::new(-1.0, 1.0, 0.3), Vec3::ZERO);
    let quantity = Quantity::AmbientOcclusion { distance, falloff };
    let (mean, error) = measure(scene, &request(camera, quantity, 1000));
    assert!(error < 0.005 * expected);
    // The wall ends at WIDE.
    assert!((mean - expected).abs() < 3.0 * error + 5e-4, "{mean} ± {error}, expected {expected}");
}

/// A long strip perpendicular to the plane takes ½ (1 − x/√(x² + h²)) of a point's cosine (the
/// infinite strip's form factor, by crossed strings).
#[test]
fn accessibility_beside_a_wall() {
    expect_accessibility(&corner(WIDE), f32::INFINITY, 0.0, 0.5);
    for height in [0.5f32, 2.0] {
        let taken = 0.5 * (1.0 - 1.0 / (1.0 + f64::from(height).powi(2)).sqrt());
        expect_accessibility(&corner(height), f32::INFINITY, 0.0, 1.0 - taken);
    }
    expect_accessibility(&floor(grey(0.5)), f32::INFINITY, 0.0, 1.0);
}

/// With c the cosine to the wall's normal, the wall at distance x is met at x/c, and the floor's cosine
/// integrates to 2√(1 − c²) over the half turn around it: occlusion = (2/π) ∫ f(x/c) √(1 − c²) dc over
/// c > x/D. For f = 1 that is (acos k − k√(1 − k²))/π with k = x/D.
#[test]
fn accessibility_with_reach_and_falloff() {
    for distance in [1.5f64, 4.0] {
        let k = 1.0 / distance;
        let taken = (k.acos() - k * (1.0 - k * k).sqrt()) / PI;
        expect_accessibility(&corner(WIDE), distance as f32, 0.0, 1.0 - taken);
    }
    for lambda in [0.5f64, 3.0] {
        // c = 1 − s² takes the root's infinite slope off the quadrature's end.
        let integrand = |s: f64| {
            let c = 1.0 - s * s;
            let f = if c > 0.25 { 1.0 / (1.0 + lambda / c) } else { 0.0 };
            f * (1.0 - c * c).sqrt() * 2.0 * s
        };
        expect_accessibility(&corner(WIDE), 4.0, lambda as f32, 1.0 - 2.0 / PI * simpson(integrand));
    }
}

/// The part of a unit disc on the far side of a line at signed distance `s` from its centre.
fn disc_beyond(s: f64) -> f64 {
    let s = s.clamp(-1.0, 1.0);
    (s.acos() - s * (1.0 - s * s).sqrt()) / PI
}

/// A roof at height 10 over all x > `edge`.
fn roofed(edge: f32) -> Scene {
    let mut scene = floor(grey(0.5));
    let at = |x: f32, z: f32| Vec3::new(x, 10.0, z * WIDE);
    let roof = [at(edge, -1.0), at(WIDE, -1.0), at(WIDE, 1.0), at(edge, 1.0)];
    add_quads(&mut scene, grey(0.5), &[roof]);
    scene
}

#[track_caller]
fn expect_visibility(scene: &Scene, expected: f64) {
    let camera = look(Vec3::new(0.3, 1.0, 0.2), Vec3::ZERO);
    let (mean, error) = measure(scene, &request(camera, Quantity::SoftShadow { light: 0 }, 1000));
    // The pixels see 3·10⁻⁴ of the disc's width apart; a disc of 4° is flat to 10⁻³.
    assert!((mean - expected).abs() < 3.0 * error + 1e-3, "{mean} ± {error}, expected {expected}");
}

#[test]
fn the_penumbra_of_a_straight_edge() {
    let radius = 2f64.to_radians().tan() * 10.0;
    for part in [-1.2, -0.6, 0.0, 0.3, 0.9, 1.2] {
        let mut scene = roofed((part * radius) as f32);
        let angular_diameter = 4f32.to_radians();
        add_light(&mut scene, LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter }, 1.0);
        expect_visibility(&scene, 1.0 - disc_beyond(part));
    }
    // A sphere twice as high, of which the edge covers the same part.
    let mut scene = roofed((0.3 * radius) as f32);
    let sphere = LightKind::Point { position: dvec3(0.0, 20.0, 0.0), radius: 20.0 * 2f32.to_radians().sin() };
    add_light(&mut scene, sphere, 1.0);
    expect_visibility(&scene, 1.0 - disc_beyond(0.3));
}

#[test]
fn lights_without_size_are_seen_or_not() {
    for (edge, visible) in [(-0.1, 0.0), (0.1, 1.0)] {
        let mut scene = roofed(edge);
        add_light(&mut scene, LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter: 0.0 }, 1.0);
        expect_visibility(&scene, visible);
        scene.lights[0].kind = LightKind::Point { position: dvec3(0.0, 20.0, 0.0), radius: 0.0 };
        expect_visibility(&scene, visible);
        // Below the roof.
        scene.lights[0].kind = LightKind::Point { position: dvec3(0.0, 9.0, 0.0), radius: 0.0 };
        expect_visibility(&scene, 1.0);
    }
}

#[test]
fn what_lies_below_the_horizon_is_hidden_by_the_surface_itself() {
    let mut scene = floor(grey(0.5));
    add_light(&mut scene, LightKind::Directional { direction: Vec3::Y, angular_diameter: 0.1 }, 1.0);
    expect_visibility(&scene, 0.0);
    // Half of it gives nothing; of what the other half gives, all arrives.
    scene.lights[0].kind = LightKind::Directional { direction: Vec3::X, angular_diameter: 0.1 };
    expect_visibility(&scene, 1.0);
}

#[test]
fn nothing_is_hidden_within_a_light_or_where_there_is_no_surface() {
    let mut scene = roofed(-1.0);
    add_light(&mut scene, LightKind::Point { position: dvec3(0.0, 0.5, 0.0), radius: 2.0 }, 1.0);
    expect_visibility(&scene, 1.0);
    let away = look(Vec3::new(-5.0, 1.0, 0.0), Vec3::new(-6.0, 3.0, 0.0));
    for quantity in
        [Quantity::SoftShadow { light: 0 }, Quantity::AmbientOcclusion { distance: 1.0, falloff: 0.0 }]
    {
        assert_eq!(measure(&scene, &request(away.clone(), quantity, 2)), (1.0, 0.0));
    }
}

/// Shadow rays end at the sphere's near side: what is within it hides nothing.
#[test]
fn a_plate_within_a_light_does_not_hide_it() {
    let mut scene = floor(grey(0.5));
    add_disc(&mut scene, grey(0.5), Vec3::new(0.0, 2.0, 0.0), 0.4, false);
    add_light(&mut scene, LightKind::Point { position: dvec3(0.0, 2.0, 0.0), radius: 0.5 }, 1.0);
    expect_visibility(&scene, 1.0);
    // Smaller than the plate, the light is behind it and then before it.
    scene.lights[0].kind = LightKind::Point { position: dvec3(0.0, 2.2, 0.0), radius: 0.1 };
    expect_visibility(&scene, 0.0);
    scene.lights[0].kind = LightKind::Point { position: dvec3(0.0, 1.8, 0.0), radius: 0.1 };
    expect_visibility(&scene, 1.0);
}
