//! Lamps of every form against closed forms: tubes, screens, spots, and mirrors that show them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use glam::Vec3;
use voxlume::Camera;
use voxlume::scene::{Material, Texture, TextureRef};
use voxlume_tests::{add, form_factor, image, mean, scene_from, triangles};

/// A tube of radius r and length 2h at a height d gives the point below its middle what a line of that width gives:
/// ∫ 2r L (d/D)² d s/D² with D² = d² + s². A tube of 24 sides is narrower by 0.3 %, and r/d is small.
#[test]
fn a_tube_gives_what_its_surface_sends() {
    for (radius, half) in [(0.04, 0.9_f64), (0.015, 0.6)] {
        let scene = scene_from(&format!(
            r#"(
                materials: {{"dark": (base_color: 0), "tube": (base_color: 0, emission: 20)}},
                objects: [
                    (name: "floor", material: "dark", shape: Grid(size: (4, 4))),
                    (name: "tube", material: "tube", shape: Cylinder(radius: {radius}, height: {}, segments: 24), rotate_deg: (0, 0, 90), translate: ({half}, 1, 0)),
                ],
                cameras: [(name: "beside", eye: (0, 1.5, 1.9), target: (0, 0, 0), fov_deg: 1)],
            )"#,
            2.0 * half
        ));
        let line = half / (1.0 + half * half) + half.atan();
        let expected = 2.0 * radius * 20.0 * line;
        let found = mean(&image(&scene, "diffuse", 64, &[("diffuse", "lamps", 8.0)]))[0];
        println!("{found}, expected {expected}");
        assert!((found / expected - 1.0).abs() < 0.025, "{found}, expected {expected}");
    }
}

/// A screen of black and white columns is half as bright as a plain one, and dark at its back. It is twice as bright here.
#[test]
fn a_textured_screen_is_as_a_plain_one() {
    let expected = 5.0 * PI * form_factor::of_rectangle([-0.6, 0.6], [-0.35, 0.35], 1.0);
    let screen = |behind: bool, textured: bool| {
        let mut scene = scene_from(&format!(
            r#"(
                materials: {{"dark": (base_color: 0, metallic: 1), "screen": (base_color: 0, emission: 5)}},
                objects: [
                    (name: "wall", material: "dark", shape: Quad(corners: [(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)])),
                    (name: "before", material: "dark", shape: Quad(corners: [(2, -2, 1.1), (-2, -2, 1.1), (-2, 2, 1.1), (2, 2, 1.1)])),
                ],
                cameras: [(name: "in", eye: (0, 1.6, 0.6), target: (0, 0, {}), fov_deg: 1)],
            )"#,
            // Past the screen's edge to the wall, or to what it shines on.
            if behind { "-0.9" } else { "1.1" }
        ));
        if behind {
            let eye = glam::DVec3::new(0.0, 1.6, 0.05);
            scene.cameras = vec![
                Camera::look_at("in", eye, glam::DVec3::new(0.0, 0.5, 0.0), glam::DVec3::Z, 0.02).unwrap(),
            ];
        }
        let corner = |x: f32, y: f32| Vec3::new(0.6 * x, 0.35 * y, 0.1);
        let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let mut mesh = triangles(&[[a, b, c], [a, c, d]]);
        mesh.uvs = mesh.positions.iter().map(|p| glam::Vec2::new(p.x / 1.2 + 0.5, 0.5)).collect();
        if textured {
            scene.textures.push(Texture {
                name: "columns".into(),
                width: 64,
                height: 1,
                rgba: (0..64).flat_map(|x| [[255, 255, 255, 255], [0, 0, 0, 255]][x % 2]).collect(),
                srgb: true,
            });
            scene.materials[1].emission *= 2.0;
            scene.materials[1].emission_texture = Some(TextureRef { texture: 0 });
        }
        add(&mut scene, voxlume::scene::Mesh { material: 1, ..mesh });
        scene
    };
    // A plain one is an area light, direct light of pixels; it shows in what else they reflect, so from a white floor.
    let textured = mean(&image(&screen(false, true), "diffuse", 64, &[("diffuse", "lamps", 8.0)]))[0];
    println!("{textured}, expected {expected}");
    assert!((textured / expected - 1.0).abs() < 0.02, "{textured}, expected {expected}");
    // At grazing angles black reflects as well, what comes back by way of the wall before it.
    for textured in [true, false] {
        let behind = mean(&image(&screen(true, textured), "diffuse", 64, &[]))[0];
        assert!(behind < 0.001 * expected, "textured: {textured}: {behind}");
    }
    let lit = |textured: bool| {
        let mut scene = screen(false, textured);
        scene.materials[0] = Material {
            name: "dark".into(),
            base_color: glam::Vec4::new(0.5, 0.5, 0.5, 1.0),
            ..Material::default()
        };
        mean(&image(&scene, "final", 64, &[("diffuse", "lamps", 8.0), ("light", "lamps", 8.0)]))[0]
    };
    let [plain, textured] = [lit(false), lit(true)];
    println!("{textured}, plain {plain}");
    // One is gathered by voxels, the other direct light of pixels: their errors differ.
    assert!((textured / plain - 1.0).abs() < 0.03, "{textured}, plain {plain}");
}

/// A spot whose edge is hard: all of its light within, none beyond.
#[test]
fn a_hard_spot_ends_at_its_edge() {
    for (degrees, lit) in [(0.0_f64, true), (24.5, true), (25.5, false), (50.0, false)] {
        let x = 2.0 * degrees.to_radians().tan();
        let scene = scene_from(&format!(
            r#"(
                materials: {{"matte": (base_color: 0.5)}},
                objects: [(name: "floor", material: "matte", shape: Grid(size: (6, 6)))],
                lights: [Spot(name: "spot", position: (0, 2, 0), direction: (0, -1, 0), intensity: 7, radius: 0.02, inner_deg: 25, outer_deg: 25)],
                cameras: [(name: "above", eye: ({x}, 2, 0.3), target: ({x}, 0, 0), fov_deg: 0.4)],
            )"#
        ));
        let shadow = mean(&image(&scene, "shadow", 32, &[]))[0];
        let found = mean(&image(&scene, "final", 32, &[]))[0];
        if lit {
            assert!(shadow > 0.999, "{degrees}°: visibility {shadow}");
            // E = I cos³θ/h². Dielectrics of roughness 1 reflect 0.96 of it diffusely, and of the rest about as much as in even light.
            let expected = 0.5 / PI * 7.0 * degrees.to_radians().cos().powi(3) / 4.0;
            assert!((0.95..1.05).contains(&(found / expected)), "{degrees}°: {found}, about {expected}");
        } else {
            assert_eq!((shadow, found), (0.0, 0.0), "{degrees}°");
        }
    }
}

/// The mirror image of a square lamp in polished metal is square and as bright as the metal reflects: Schlick's Fresnel for 0.9.
#[test]
fn a_mirror_shows_a_square_lamp_as_a_square() {
    let show = |x: f64, z: f64| {
        let scene = scene_from(&format!(
            r#"(
                materials: {{"metal": (base_color: 0.9, metallic: 1, roughness: 0.05), "lamp": (base_color: 0, emission: 8)}},
                objects: [
                    (name: "floor", material: "metal", shape: Grid(size: (5, 5))),
                    (name: "lamp", material: "lamp", shape: Quad(corners: [(-0.5, 2, -0.5), (0.5, 2, -0.5), (0.5, 2, 0.5), (-0.5, 2, 0.5)])),
                ],
                cameras: [(name: "above", eye: (0.3, 1.5, 1.9), target: ({x}, -2, {z}), fov_deg: 0.5)],
            )"#
        ));
        let down = 3.5 / ((0.3 - x).powi(2) + 3.5_f64.powi(2) + (1.9 - z).powi(2)).sqrt();
        let reflected = 0.9 + 0.1 * (1.0 - down).powi(5);
        mean(&image(&scene, "final", 64, &[]))[0] / (8.0 * reflected)
    };
    for (x, z) in [(0.0, 0.0), (0.38, 0.38), (-0.38, 0.38), (0.38, -0.38)] {
        let found = show(x, z);
        println!("({x}, {z}): {found:.3} of the lamp");
        assert!((found - 1.0).abs() < 0.03, "({x}, {z}): {found} of the lamp");
    }
    // Its lobe is 0.3° wide; a disc as large as the lamp would still reach this far along x.
    for (x, z) in [(0.58, 0.0), (0.58, 0.58), (0.0, -0.58)] {
        let found = show(x, z);
        println!("({x}, {z}): {found:.4} of the lamp");
        assert!(found < 0.02, "({x}, {z}): {found} of the lamp");
    }
}
