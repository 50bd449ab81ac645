//! Input that is odd or wrong and that files have all the same: images are finite, and as bright as they should be.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use glam::Vec3;
use voxlume::Scene;
use voxlume_tests::{form_factor, image, mean, scene_from};

/// Rays of a pixel, so that few directions are no part of the error.
const RAYS: (&str, &str, f64) = ("diffuse", "rays", 16.0);

fn diffuse(scene: &Scene) -> [f64; 3] {
    let image = image(scene, "diffuse", 64, &[RAYS]);
    assert!(image.pixels.iter().flatten().all(|value| value.is_finite()));
    mean(&image)
}

fn same(a: [f64; 3], b: [f64; 3], tolerance: f64) {
    println!("{a:?} {b:?}");
    assert!(a.iter().zip(b).all(|(a, b)| *a > 0.0 && (a / b - 1.0).abs() < tolerance), "{a:?} and {b:?}");
}

/// A room with a block, all of two sides or not, its meshes mirrored or not. What is mirrored is symmetrical.
fn room(double_sided: bool, mirrored: bool) -> Scene {
    let scale = if mirrored { -1 } else { 1 };
    scene_from(&format!(
        r#"(
            materials: {{
                "white": (base_color: 0.7, double_sided: {double_sided}), "red": (base_color: (0.7, 0.1, 0.1), double_sided: {double_sided}),
                "lamp": (base_color: 0, emission: 9),
            }},
            objects: [
                (name: "walls", material: "white", shape: Box(min: (-1.5, 0, -1), max: (1.5, 1.8, 1.2)), inside_out: true, scale: ({scale}, 1, 1)),
                (name: "block", material: "red", shape: Box(min: (-0.4, 0, -0.5), max: (0.4, 0.7, 0.1)), scale: ({scale}, 1, 1)),
                (name: "lamp", material: "lamp", shape: Quad(corners: [(-0.4, 1.7, -0.3), (0.4, 1.7, -0.3), (0.4, 1.7, 0.3), (-0.4, 1.7, 0.3)])),
            ],
            cameras: [(name: "in", eye: (0.3, 1.2, 1.1), target: (0, 0.4, 0), fov_deg: 70)],
        )"#
    ))
}

#[test]
fn double_sided_and_mirrored() {
    let plain = diffuse(&room(false, false));
    for (double_sided, mirrored) in [(false, true), (true, false), (true, true)] {
        same(diffuse(&room(double_sided, mirrored)), plain, 0.01);
    }
}

/// A black floor under a roof of no thickness: its light is that of the sky around it.
#[test]
fn boxes_without_thickness() {
    for roof in [
        "Box(min: (-1, 1, -1), max: (1, 1, 1))",
        "Quad(corners: [(-1, 1, 1), (1, 1, 1), (1, 1, -1), (-1, 1, -1)])",
    ] {
        let scene = scene_from(&format!(
            r#"(
                materials: {{"black": (base_color: 0, metallic: 1)}},
                objects: [
                    (name: "floor", material: "black", shape: Box(min: (-1.5, 0, -1.5), max: (1.5, 0, 1.5))),
                    (name: "roof", material: "black", shape: {roof}),
                ],
                sky: 1,
                cameras: [(name: "under", eye: (0.4, 0.7, 0.5), target: (0, 0, 0), fov_deg: 1)],
            )"#
        ));
        let expected = PI * (1.0 - form_factor::of_rectangle([-1.0, 1.0], [-1.0, 1.0], 1.0));
        same(diffuse(&scene), [expected; 3], 0.02);
    }
}

/// A wall that is two sheets in the same place, red to one side and green to the other, in a lit room: the red side's part of the room
/// is as with a wall that is red alone.
#[test]
fn coincident_faces_of_two_colours() {
    let parted = |back: &str| {
        scene_from(&format!(
            r#"(
                materials: {{
                    "white": (base_color: 0.7), "red": (base_color: (0.8, 0.05, 0.05)), "green": (base_color: (0.05, 0.8, 0.05)),
                    "lamp": (base_color: 0, emission: 9),
                }},
                objects: [
                    (name: "walls", material: "white", shape: Box(min: (-2, 0, -1), max: (2, 1.5, 1)), inside_out: true),
                    (name: "front", material: "red", shape: Quad(corners: [(0, 0, -1), (0, 0, 1), (0, 1.5, 1), (0, 1.5, -1)])),
                    (name: "back", material: "{back}", shape: Quad(corners: [(0, 0, -1), (0, 1.5, -1), (0, 1.5, 1), (0, 0, 1)])),
                    (name: "east lamp", material: "lamp", shape: Quad(corners: [(0.5, 1.4, -0.4), (1.3, 1.4, -0.4), (1.3, 1.4, 0.4), (0.5, 1.4, 0.4)])),
                    (name: "west lamp", material: "lamp", shape: Quad(corners: [(-1.3, 1.4, -0.4), (-0.5, 1.4, -0.4), (-0.5, 1.4, 0.4), (-1.3, 1.4, 0.4)])),
                ],
                cameras: [(name: "east", eye: (1.6, 0.9, 0.5), target: (0.3, 0, 0), fov_deg: 20)],
            )"#
        ))
    };
    // The camera looks at the back.
    let [red, green, blue] = diffuse(&parted("red"));
    same(diffuse(&parted("green")), [green, red, blue], 0.01);
}

#[test]
fn a_lamp_in_a_closed_box_lights_nothing_outside() {
    let scene = scene_from(
        r#"(
            materials: {"white": (base_color: 0.8), "lamp": (base_color: 0.5, emission: 500)},
            objects: [
                (name: "floor", material: "white", shape: Grid(size: (3, 3))),
                (name: "box", material: "white", shape: Box(min: (-0.5, 0.3, -0.5), max: (0.5, 1.1, 0.5)), rotate_deg: (0, 20, 0)),
                (name: "bulb", material: "lamp", shape: Sphere(radius: 0.2, segments: 16), translate: (0, 0.7, 0)),
            ],
            cameras: [(name: "front", eye: (1.5, 1.6, 2.4), target: (0, 0.3, 0), fov_deg: 40)],
        )"#,
    );
    for output in ["diffuse", "final"] {
        let found = mean(&image(&scene, output, 64, &[]))[0];
        // The box stands askew in the grid: of the lamp's 500, 2·10⁻⁷ get through its edges.
        assert!(found < 3e-7 * 500.0, "{output}: {found}");
    }
}

/// A lamp in the ceiling's own plane, and one that reaches into it: each as bright as alone.
#[test]
fn lamps_that_touch_the_ceiling() {
    for height in [1.5, 1.499, 1.49] {
        let scene = scene_from(&format!(
            r#"(
                materials: {{"black": (base_color: 0), "white": (base_color: 0.5), "lamp": (base_color: 0, emission: 6)}},
                objects: [
                    (name: "floor", material: "white", shape: Grid(size: (3, 3))),
                    (name: "ceiling", material: "black", shape: Quad(corners: [(-1.5, 1.5, -1.5), (1.5, 1.5, -1.5), (1.5, 1.5, 1.5), (-1.5, 1.5, 1.5)])),
                    (name: "lamp", material: "lamp", shape: Quad(corners: [(-0.5, {height}, -0.3), (0.5, {height}, -0.3), (0.5, {height}, 0.3), (-0.5, {height}, 0.3)])),
                ],
                cameras: [(name: "in", eye: (0.3, 1.2, 0.4), target: (0, 0, 0), fov_deg: 1)],
            )"#
        ));
        let visible = mean(&image(&scene, "shadow", 64, &[]))[0];
        assert!(visible > 0.999, "{height}: {visible}");
        let irradiance = 6.0 * PI * form_factor::of_rectangle([-0.5, 0.5], [-0.3, 0.3], height);
        let found = mean(&image(&scene, "final", 64, &[]))[0];
        // Dielectrics of roughness 1 reflect 0.96 of it diffusely, and of the rest about as much as in even light.
        let expected = 0.5 / PI * irradiance;
        println!("{height}: {found}, about {expected}");
        assert!((0.95..1.05).contains(&(found / expected)), "{height}: {found}, about {expected}");
    }
}

/// A sun that comes from below the floor lights nothing over it.
#[test]
fn a_sun_from_below_the_floor() {
    for diameter in [0, 20] {
        let scene = scene_from(&format!(
            r#"(
                materials: {{"white": (base_color: 0.8)}},
                objects: [
                    (name: "floor", material: "white", shape: Grid(size: (4, 4))),
                    (name: "block", material: "white", shape: Box(min: (-0.5, 0, -0.5), max: (0.4, 0.8, 0.3))),
                ],
                lights: [Directional(name: "sun", direction: (0.2, 1, 0.1), irradiance: 50, angular_diameter_deg: {diameter})],
                cameras: [(name: "front", eye: (0.9, 1.3, 1.8), target: (0, 0.3, 0), fov_deg: 30)],
            )"#
        ));
        for output in ["diffuse", "final"] {
            let found = mean(&image(&scene, output, 64, &[]))[0];
            // Rays that begin at the block's foot get through where it meets the floor: 5·10⁻⁶ of the sun's irradiance.
            assert!(found < 6e-6 * 50.0, "{output}, a sun of {diameter}°: {found}");
        }
    }
}

/// Normals that say nothing, or that are turned against the winding: the front is where the winding says.
#[test]
fn normals_that_are_zero_or_inwards() {
    let plain = room(false, false);
    let right = diffuse(&plain);
    for (what, factor) in [("inwards", -1.0), ("zero", 0.0)] {
        let mut scene = plain.clone();
        for mesh in &mut scene.meshes {
            mesh.normals.iter_mut().for_each(|normal| *normal *= factor);
        }
        println!("{what}");
        same(diffuse(&scene), right, 0.01);
        same(mean(&image(&scene, "final", 64, &[])), mean(&image(&plain, "final", 64, &[])), 0.01);
    }
}

/// A ceiling of more than 10⁴ emissive triangles is as bright as one of two.
#[test]
fn ten_thousand_emissive_triangles() {
    let scene = scene_from(
        r#"(
            materials: {"dark": (base_color: 0), "lamp": (base_color: 0, emission: 3)},
            objects: [
                (name: "floor", material: "dark", shape: Grid(size: (4, 4))),
                (name: "ceiling", material: "lamp", shape: Grid(size: (1.6, 1.2), cells: (80, 65)), rotate_deg: (180, 0, 0), translate: (0, 1.1, 0)),
            ],
            cameras: [(name: "beside", eye: (0, 1, 1.9), target: (0, 0, 0), fov_deg: 1)],
        )"#,
    );
    assert!(scene.meshes.iter().map(|mesh| mesh.triangles.len()).max() > Some(10_000));
    let expected = 3.0 * PI * form_factor::of_rectangle([-0.8, 0.8], [-0.6, 0.6], 1.1);
    let found = mean(&image(&scene, "diffuse", 64, &[("diffuse", "lamps", 8.0)]));
    same(found, [expected; 3], 0.02);
    assert!(Vec3::from(found.map(|value| value as f32)).is_finite());
}
