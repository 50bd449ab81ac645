//! Closed boxes and constant skies, where every answer is a sum on paper.

use glam::{Vec3, Vec4};
use voxlume_reference::{Gather, Quantity};
use voxlume_scene::{LightKind, Material, Scene};

use crate::stage::*;

const ALBEDO: f64 = 0.6;
const RADIANCE: f64 = 2.0;

/// A closed box whose sides all emit and reflect alike.
fn furnace() -> Scene {
    let mut scene = Scene::default();
    let material = Material { emission: Vec3::splat(RADIANCE as f32), ..grey(ALBEDO as f32) };
    add_quads(&mut scene, material, &room(Vec3::new(-1.0, 0.0, -2.0), Vec3::new(1.5, 2.0, 2.0)));
    scene
}

/// Σ ρᵏ over a range of bounces.
fn series(bounces: std::ops::RangeInclusive<u32>) -> f64 {
    bounces.map(|k| ALBEDO.powi(k as i32)).sum()
}

#[test]
fn the_final_image_of_a_furnace() {
    let camera = look(Vec3::new(0.0, 1.0, 0.0), Vec3::new(1.5, 0.7, 0.4));
    for bounces in [0, 1, 2, 5] {
        let request = lambert(camera.clone(), Quantity::Final { bounces }, 200);
        expect(&furnace(), &request, RADIANCE * series(0..=bounces + 1));
    }
}

#[test]
fn the_diffuse_irradiance_of_a_furnace() {
    // Near a corner, where sampling is hardest.
    let camera = look(Vec3::new(0.0, 1.0, 0.0), Vec3::new(1.45, 0.0, 1.95));
    for bounces in [1, 2, 4] {
        let gather = Gather { bounces, sky: true, emission: false };
        let request = lambert(camera.clone(), Quantity::Diffuse(gather), 300);
        expect(&furnace(), &request, PI * RADIANCE * series(1..=bounces));
        let request = lambert(camera.clone(), Quantity::Diffuse(Gather { emission: true, ..gather }), 300);
        expect(&furnace(), &request, PI * RADIANCE * series(0..=bounces));
    }
}

#[test]
fn the_specular_lobe_of_a_furnace_averages_its_radiance() {
    let mut scene = furnace();
    let camera = look(Vec3::new(0.0, 1.0, 0.0), Vec3::new(1.5, 0.7, 0.4));
    for roughness in [0.0, 0.3, 1.0] {
        scene.materials[0].roughness = roughness;
        let gather = Gather { bounces: 2, sky: true, emission: true };
        let request = lambert(camera.clone(), Quantity::Specular(gather), 300);
        expect(&scene, &request, RADIANCE * series(0..=2));
    }
}

#[test]
fn a_plane_under_a_constant_sky() {
    let mut scene = floor(grey(0.5));
    scene.sky = Vec3::new(3.0, 0.0, 0.0);
    let camera = look(Vec3::new(0.0, 2.0, 1.0), Vec3::ZERO);
    let seen = Gather { bounces: 0, sky: true, emission: false };
    expect(&scene, &request(camera.clone(), Quantity::Diffuse(seen), 2), 3.0 * PI);
    expect(&scene, &request(camera.clone(), Quantity::Specular(seen), 2), 3.0);
    expect(&scene, &lambert(camera.clone(), Quantity::Final { bounces: 0 }, 2), 1.5);
    let unseen = request(camera, Quantity::Diffuse(Gather { sky: false, ..seen }), 2);
    assert_eq!(measure(&scene, &unseen), (0.0, 0.0));
    // Where there is no surface, the final image shows the sky.
    let up = look(Vec3::Y, Vec3::Y * 2.0);
    expect(&scene, &request(up, Quantity::Final { bounces: 0 }, 2), 3.0);
}

/// Sunlight along +x on a wall that faces it; the floor before the wall is edge-on to the sun and sees
/// the wall fill half of its hemisphere's cosine: E = ½ · ρ · E₀. The wall's own second bounce comes
/// by way of the floor: floor irradiance ½ρE₀ everywhere makes ½ · ρ · ½ρE₀ at the wall, which adds
/// ½ρ times that at the floor on the third reflection.
#[test]
fn a_sunlit_wall_lights_the_floor() {
    let (albedo, sun) = (0.8, 5.0);
    let mut scene = floor(grey(albedo));
    let corner = |y: f32, z: f32| Vec3::new(1.0, y * WIDE, z * WIDE);
    let wall = [corner(0.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(0.0, -1.0)];
    add_quads(&mut scene, grey(albedo), &[wall]);
    add_light(&mut scene, LightKind::Directional { direction: Vec3::X, angular_diameter: 0.0 }, sun);
    let camera = look(Vec3::new(-2.0, 2.0, 1.0), Vec3::new(0.2, 0.0, 0.0));
    let once = f64::from(albedo * sun) / 2.0;
    let again = once * f64::from(albedo).powi(2) / 4.0;
    for (bounces, expected) in [(1, once), (2, once), (3, once + again)] {
        let gather = Gather { bounces, sky: false, emission: false };
        // The wall ends at WIDE, three thousand times as far as the floor point.
        let (mean, error) = measure(&scene, &lambert(camera.clone(), Quantity::Diffuse(gather), 2000));
        assert!(error < 0.005 * expected);
        assert!(
            (mean - expected).abs() < 3.0 * error + 1e-3 * expected,
            "{bounces}: {mean} {error} {expected}"
        );
    }
}

/// A surface with a normal map leaning out of its plane reflects no light from below its own triangle.
#[test]
fn light_from_below_the_triangle_is_not_counted() {
    let mut scene = floor(grey(1.0));
    // 45° towards the tangent.
    scene.materials[0].normal_texture = add_texture(&mut scene, 1, false, &[[218, 128, 218, 255]]);
    scene.sky = Vec3::ONE;
    let camera = look(Vec3::new(0.0, 2.0, 1.0), Vec3::ZERO);
    // A hemisphere tilted by t keeps (1 + cos t)/2 of its cosine above the plane.
    let expected = (1.0 + (PI / 4.0).cos()) / 2.0;
    let (mean, error) = measure(&scene, &lambert(camera, Quantity::Final { bounces: 0 }, 2000));
    // The texel's 218/255 is 45° to 0.3 %.
    assert!((mean - expected).abs() < 3.0 * error + 3e-3, "{mean} {error} {expected}");
}

/// Single scattering loses light on rough metal but never gains any. (glTF's dielectrics are no such case:
/// their base is dimmed by the Fresnel term at the half vector, so that a bright one can reflect more
/// than it receives towards a grazing eye.)
#[test]
fn a_white_furnace_of_metal_gains_no_energy() {
    for roughness in [0.0, 0.1, 0.5, 1.0] {
        let mut scene = floor(Material { metallic: 1.0, roughness, base_color: Vec4::ONE, ..grey(1.0) });
        scene.sky = Vec3::ONE;
        for eye in [Vec3::new(0.0, 2.0, 0.5), Vec3::new(0.0, 0.2, 2.0)] {
            let (mean, error) =
                measure(&scene, &request(look(eye, Vec3::ZERO), Quantity::Final { bounces: 3 }, 200));
            let least = if roughness < 0.2 { 0.97 } else { 0.3 };
            assert!((least..1.0 + 3.0 * error + 1e-5).contains(&mean), "{roughness}: {mean}");
        }
    }
}
