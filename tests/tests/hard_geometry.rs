//! Geometry that breaks renderers: no panic, finite images.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{DAffine3, DVec3, Vec3};
use voxlume::{Picture, Request, Scene};
use voxlume_tests::{gi, picture, place, render, scene_of, soup, span, triangle, triangles};

const SIDE: f64 = 29.0;

fn request(output: &str) -> Request {
    Request { resolution: Some(32), output: Some(output.into()), ..Request::image(16, 16) }
}

fn is_finite(picture: &Picture) -> bool {
    picture.pixels.iter().flatten().all(|value| value.is_finite())
}

/// The scene's image, lit by the sky, with every image on the way to it.
fn render_finite(what: &str, mut scene: Scene) -> Picture {
    scene.sky = Vec3::new(0.4, 0.5, 0.6);
    let renderer = render(&gi(), &scene, &request("final"));
    for name in ["normal", "diffuse", "final"] {
        assert!(is_finite(&picture(&renderer, name)), "{what}: `{name}` is not finite");
    }
    picture(&renderer, "final")
}

fn floor() -> voxlume::scene::Mesh {
    let (low, high) = (0.0, SIDE as f32);
    triangles(&[
        [[low, 1.0, high].into(), [high, 1.0, high].into(), [high, 1.0, low].into()],
        [[low, 1.0, high].into(), [high, 1.0, low].into(), [low, 1.0, low].into()],
    ])
}

fn with_floor(mesh: voxlume::scene::Mesh) -> Scene {
    scene_of(vec![floor(), span(SIDE as f32), mesh], SIDE)
}

#[test]
fn zero_area() {
    let point = triangle([9.0; 3], [9.0; 3], [9.0; 3]);
    let line = triangle([2.0, 3.0, 4.0], [12.0, 13.0, 14.0], [7.0, 8.0, 9.0]);
    render_finite("a point", with_floor(point.clone()));
    render_finite("a line", with_floor(line));
    render_finite("nothing but a point", scene_of(vec![point], SIDE));
}

#[test]
fn slivers() {
    let list: Vec<[Vec3; 3]> = soup(21, 100, SIDE, (5.0, 25.0))
        .into_iter()
        .enumerate()
        .map(|(i, [a, b, c])| [a, b, a.lerp(b, 0.4).lerp(c, 10f32.powi(-(i as i32 % 9)))])
        .collect();
    render_finite("slivers", with_floor(triangles(&list)));
}

#[test]
fn duplicates() {
    let mut mesh = triangles(&soup(22, 3, SIDE, (5.0, 10.0)));
    // Front and back, each many times.
    mesh.triangles =
        mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b, c], [a, c, b]]).cycle().take(600).collect();
    render_finite("duplicates", with_floor(mesh));
}

#[test]
fn one_triangle_across_the_scene() {
    let side = SIDE as f32;
    let across = triangle([0.0, 0.0, 0.0], [side, side, 0.0], [0.0, side, side]);
    render_finite("a triangle across the scene", scene_of(vec![across], SIDE));
}

#[test]
fn a_flat_scene() {
    render_finite("a floor alone", scene_of(vec![floor()], SIDE));
}

#[test]
fn flattened_and_mirrored_instances() {
    let mut scene = with_floor(span(1.0));
    let mesh = || triangles(&soup(23, 40, 10.0, (1.0, 8.0)));
    place(&mut scene, mesh(), DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0)));
    place(&mut scene, mesh(), DAffine3::from_scale(DVec3::new(1.0, 0.0, 2.0)));
    place(&mut scene, mesh(), DAffine3::from_scale(DVec3::new(3.0, 1e-6, -1e-3)));
    render_finite("flattened instances", scene);
}

/// The same picture wherever the scene lies and however large it is.
#[test]
fn far_off_tiny_and_huge_scenes() {
    let picture_of = |transform: DAffine3| {
        let mut scene = with_floor(triangles(&soup(24, 40, SIDE, (2.0, 10.0))));
        for instance in &mut scene.instances {
            instance.transform = transform;
        }
        let camera = &mut scene.cameras[0];
        camera.eye = transform.transform_point3(camera.eye);
        render_finite("a moved scene", scene)
    };
    let here = picture_of(DAffine3::IDENTITY);
    for (what, transform) in [
        ("10⁶ away", DAffine3::from_translation(DVec3::new(1e6, -1e6, 1e6))),
        ("10⁻⁴ wide", DAffine3::from_scale(DVec3::splat(1e-4 / SIDE))),
        ("10⁴ wide", DAffine3::from_scale(DVec3::splat(1e4 / SIDE))),
    ] {
        let there = picture_of(transform);
        let error =
            |(a, b): (&[f32; 4], &[f32; 4])| (0..3).map(|i| f64::from(a[i] - b[i]).abs()).sum::<f64>() / 3.0;
        let mean = here.pixels.iter().zip(&there.pixels).map(error).sum::<f64>() / here.pixels.len() as f64;
        println!("{what}: mean difference {mean:.2e}");
        assert!(mean < 5e-3, "{what}: mean difference {mean}");
    }
}

#[test]
fn an_empty_scene_shows_the_sky() {
    let picture = render_finite("nothing", scene_of(Vec::new(), SIDE));
    for pixel in &picture.pixels {
        for (value, sky) in pixel.iter().zip([0.4, 0.5, 0.6]) {
            assert!((value - sky).abs() < 1e-3, "{pixel:?}");
        }
    }
}
