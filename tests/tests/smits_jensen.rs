//! Two scenes of Smits and Jensen (Global Illumination Test Scenes, UUCS-00-013, 2000) whose answers are known in closed form.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use glam::DVec3;
use voxlume::twin::total_reflectance;
use voxlume::{Camera, Request, Value};
use voxlume_tests::{built_in, form_factor, gi, image, mean, picture, render};

/// Irradiance of the plane, gathered by rays, and radiance, by direct light of pixels.
#[test]
fn a_polygon_lights_a_plane_by_its_form_factor() {
    let mut scene = built_in("smits_jensen/polygon_over_plane.ron");
    for x in [0.0, 0.4, 0.8, 1.3] {
        let eye = DVec3::new(x, 0.5, 0.4);
        scene.cameras = vec![Camera::look_at("plane", eye, DVec3::new(x, 0.0, 0.0), DVec3::Y, 0.01).unwrap()];
        let expected = 10.0 * PI * form_factor::of_rectangle([-0.5 - x, 0.5 - x], [-0.5, 0.5], 1.0);
        let request = Request {
            resolution: Some(64),
            output: Some("diffuse".into()),
            set: vec![
                ("light".into(), "emission".into(), Value::Word("gather".into())),
                ("diffuse".into(), "rays".into(), Value::Number(256.0)),
            ],
            ..Request::image(8, 8)
        };
        let gathered = mean(&picture(&render(&gi(), &scene, &request), "diffuse"))[0];
        let direct = mean(&image(&scene, "final", 64, &[]))[0] * PI / 0.5;
        println!("{x}: gathered {gathered:.4}, direct {direct:.4}, expected {expected:.4}");
        assert!((gathered / expected - 1.0).abs() < 0.02, "{x}: gathered {gathered}, expected {expected}");
        // What a rough dielectric's coat adds and takes.
        assert!((direct / expected - 1.0).abs() < 0.06, "{x}: direct {direct}, expected {expected}");
    }
}

/// In the furnace nothing shows, in any format.
#[test]
fn a_furnace_hides_what_stands_in_it() {
    let scene = built_in("smits_jensen/furnace.ron");
    let rho = total_reflectance(DVec3::splat(0.5), 0.0, 1.0).x;
    let bounces = 10;
    // Gathered light has been emitted, and reflected by as many bounces and once by the light pass.
    let expected: f64 = (0..=bounces + 1).map(|i| 0.5 * rho.powi(i)).sum();
    assert!((expected / (0.5 / (1.0 - rho)) - 1.0).abs() < 0.001);
    for format in ["isotropic", "six_face", "sh2"] {
        let request = Request {
            format: Some(format.into()),
            resolution: Some(64),
            output: Some("diffuse".into()),
            set: vec![
                ("light".into(), "emission".into(), Value::Word("gather".into())),
                ("bounce".into(), "bounces".into(), Value::Number(f64::from(bounces))),
            ],
            ..Request::image(48, 48)
        };
        let shown = picture(&render(&gi(), &scene, &request), "diffuse");
        let mut off: Vec<f64> =
            shown.pixels.iter().map(|pixel| (f64::from(pixel[0]) / PI / expected - 1.0).abs()).collect();
        off.sort_by(f64::total_cmp);
        let [worst, most] = [1.0, 0.99].map(|share| off[((off.len() - 1) as f64 * share) as usize]);
        let mean = mean(&shown)[0] / PI / expected - 1.0;
        println!(
            "{format}: mean {:+.2} %, 99 % of pixels within {:.2} %, all within {:.2} %",
            100.0 * mean,
            100.0 * most,
            100.0 * worst
        );
        assert!(mean.abs() < 0.01 && most < 0.03, "{format}: mean {mean}, 99 % within {most}");
    }
}
