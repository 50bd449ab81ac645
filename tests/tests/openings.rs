//! Light that gets into rooms through openings of known size, and no other, against closed forms.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use glam::{DVec3, Vec3, Vec4};
use voxlume::scene::{Material, Mesh};
use voxlume::twin::total_reflectance;
use voxlume::{Camera, Scene};
use voxlume_tests::{add, form_factor, image, mean, place, scene_from, scene_of, triangles};

/// Rays of a pixel, so that few directions are no part of the error.
const RAYS: (&str, &str, f64) = ("diffuse", "rays", 32.0);

/// A house of six slabs with a polished ball in it, under a bright sky and a sun. Its walls are 1.8 voxels thick at 32³.
const HOUSE: &str = r#"(
    materials: {"wall": (base_color: 0.8), "chrome": (base_color: 0.9, metallic: 1, roughness: 0.1)},
    objects: [
        (name: "floor", material: "wall", shape: Box(min: (-1.7, -0.2, -1.4), max: (1.7, 0, 1.4))),
        (name: "roof", material: "wall", shape: Box(min: (-1.7, 2.1, -1.4), max: (1.7, 2.3, 1.4))),
        (name: "west", material: "wall", shape: Box(min: (-1.7, 0, -1.4), max: (-1.5, 2.1, 1.4))),
        (name: "east", material: "wall", shape: Box(min: (1.5, 0, -1.4), max: (1.7, 2.1, 1.4))),
        (name: "north", material: "wall", shape: Box(min: (-1.5, 0, -1.4), max: (1.5, 2.1, -1.2))),
        (name: "south", material: "wall", shape: Box(min: (-1.5, 0, 1.2), max: (1.5, 2.1, 1.4))),
        (name: "ball", material: "chrome", shape: Sphere(radius: 0.3, segments: 24), translate: (0.4, 0.3, 0.1)),
    ],
    lights: [Directional(name: "sun", direction: (-0.5, -1, -0.3), irradiance: 20, angular_diameter_deg: 1)],
    sky: 5,
    cameras: [(name: "in", eye: (-1.2, 1.4, 0.9), target: (0.5, 0.4, -0.4), fov_deg: 80)],
)"#;

#[test]
fn a_house_without_an_opening_is_dark() {
    let scene = scene_from(HOUSE);
    for resolution in [32, 64] {
        for output in ["diffuse", "specular", "final"] {
            assert_eq!(mean(&image(&scene, output, resolution, &[])), [0.0; 3], "{output} at {resolution}³");
        }
    }
}

/// A black room with a doorway in its north wall and a leaf that opens outwards by an angle, higher and lower than the doorway. From
/// the opposite wall the sky shows between the leaf's free edge and the doorway's: a rectangle in the doorway's plane.
#[test]
fn a_door_ajar_lets_in_what_its_gap_shows() {
    let (distance, low, high, width, from) = (2.2, 0.5, 1.7, 1.0, 0.75);
    let mut off = Vec::new();
    for degrees in [15.0_f64, 25.0, 40.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let scene = scene_from(&format!(
            r#"(
                materials: {{"black": (base_color: 0, metallic: 1)}},
                objects: [
                    (name: "room", material: "black", shape: Triangles(
                        positions: [
                            (-1, 0, 0), (2, 0, 0), (2, 0, {distance}), (-1, 0, {distance}), (-1, 2, 0), (2, 2, 0), (2, 2, {distance}), (-1, 2, {distance}),
                        ],
                        indices: [(0, 3, 2), (0, 2, 1), (4, 5, 6), (4, 6, 7), (0, 4, 7), (0, 7, 3), (1, 2, 6), (1, 6, 5), (3, 7, 6), (3, 6, 2)],
                    )),
                    (name: "left", material: "black", shape: Box(min: (-1, 0, -0.02), max: (0, 2, 0.02))),
                    (name: "right", material: "black", shape: Box(min: ({width}, 0, -0.02), max: (2, 2, 0.02))),
                    (name: "sill", material: "black", shape: Box(min: (0, 0, -0.02), max: ({width}, {low}, 0.02))),
                    (name: "lintel", material: "black", shape: Box(min: (0, {high}, -0.02), max: ({width}, 2, 0.02))),
                    (name: "leaf", material: "black", shape: Box(min: (0, -0.1, -0.05), max: ({width}, 2.4, -0.02)), rotate_deg: (0, {degrees}, 0)),
                ],
                sky: 1,
                cameras: [(name: "in", eye: ({from}, 1.1, 0.4), target: ({from}, 1.1, {distance}), fov_deg: 1)],
            )"#
        ));
        let [resolution, voxel] = [64.0, 3.0 / 61.0];
        let found = mean(&image(&scene, "diffuse", resolution as u32, &[RAYS]))[0] / PI;
        // The leaf's inner face is 0.02 out, its edge turned about the hinge, and seen from the opposite wall.
        let (edge, depth) = (width * cosine - 0.02 * sine, width * sine + 0.02 * cosine);
        let seen = from + (edge - from) * distance / (distance + depth);
        let between = |far: f64| {
            form_factor::of_rectangle([seen - from, far - from], [low - 1.1, high - 1.1], distance)
        };
        let gap = (width - seen) / voxel;
        let too_wide = (found / between(width) - 1.0) * gap;
        println!("{degrees}°: a gap of {gap:.2} voxels, {too_wide:+.2} too wide");
        // One square, a fifth of a voxel, of the two edges together.
        if too_wide.abs() > 0.2 {
            off.push(degrees);
        }
    }
    assert!(off.is_empty(), "{off:?}");
}

/// The inside of a ball of radius 1 about the origin, open where it is within `open` of its top, as an angle.
fn bowl(open: f64) -> Mesh {
    let (rings, sectors) = (48, 96);
    let point = |ring: usize, sector: usize| {
        let down = open + (PI - open) * ring as f64 / f64::from(rings);
        let around = 2.0 * PI * sector as f64 / f64::from(sectors);
        DVec3::new(down.sin() * around.cos(), down.cos(), down.sin() * around.sin()).as_vec3()
    };
    let mut list: Vec<[Vec3; 3]> = Vec::new();
    for ring in 0..rings as usize {
        for sector in 0..sectors as usize {
            let [a, b] = [point(ring, sector), point(ring, sector + 1)];
            let [c, d] = [point(ring + 1, sector), point(ring + 1, sector + 1)];
            list.extend([[a, c, d], [a, d, b]]);
        }
    }
    // Of the triangles at the poles one of two has no area.
    list.retain(|[a, b, c]| (*b - *a).cross(*c - *a).length() > 1e-7);
    triangles(&list)
}

fn bowl_scene(open: f64) -> Scene {
    let mut scene = scene_of(Vec::new(), 1.0);
    scene.materials[0].base_color = Vec4::new(0.8, 0.5, 0.2, 1.0);
    add(&mut scene, bowl(open));
    scene.cameras = vec![
        Camera::look_at("in", DVec3::new(0.3, 0.1, -0.2), DVec3::new(0.0, -1.0, 0.3), DVec3::X, 1.2).unwrap(),
    ];
    scene
}

/// Within a ball every piece of the wall gives every other as much light as its area's share. So through an opening that takes a
/// share f of the ball, a sky of L gives πLf everywhere, and what is reflected falls by ρ(1 − f) from bounce to bounce.
fn expect_in_ball(scene: &Scene, first: f64, lost: f64, tolerance: f64) {
    let rho = total_reflectance(DVec3::new(0.8, 0.5, 0.2), 0.0, 1.0);
    let mut off = Vec::new();
    for (bounces, resolution) in [(0, 32), (0, 64), (3, 64)] {
        let set = [RAYS, ("bounce", "bounces", f64::from(bounces))];
        let found = mean(&image(scene, "diffuse", resolution, &set));
        for (found, rho) in found.into_iter().zip(rho.to_array()) {
            let expected: f64 =
                (0..=bounces + 1).map(|bounce| first * (rho * (1.0 - lost)).powi(bounce)).sum();
            let percent = 100.0 * (found / expected - 1.0);
            println!("{bounces} bounces, {resolution}³: {found:.4}, {percent:+.2} %");
            // A wall of half as many voxels is more than twice as coarse.
            let tolerance = if resolution < 64 { 2.0 * tolerance } else { tolerance };
            if percent.abs() > 100.0 * tolerance {
                off.push(format!("{bounces} bounces, {resolution}³: {found:.4} ({percent:+.1} %)"));
            }
        }
    }
    assert!(off.is_empty(), "{off:?}");
}

#[test]
fn a_matte_room_gets_what_comes_through_its_window() {
    let open = 35.0_f64.to_radians();
    let share = (1.0 - open.cos()) / 2.0;
    let mut scene = bowl_scene(open);
    scene.sky = Vec3::ONE;
    expect_in_ball(&scene, PI * share, share, 0.02);
    // So it does with something polished in it, which takes a thousandth of the ball.
    let chrome = Material { metallic: 1.0, roughness: 0.1, ..scene.materials[0].clone() };
    scene.materials.push(chrome);
    let speck =
        triangles(&[[Vec3::new(0.05, 0.0, 0.0), Vec3::new(0.0, 0.0, 0.05), Vec3::new(-0.05, 0.0, -0.05)]]);
    place(
        &mut scene,
        Mesh { material: 1, ..speck },
        glam::DAffine3::from_translation(DVec3::new(-0.6, 0.0, 0.4)),
    );
    expect_in_ball(&scene, PI * share, share, 0.02);
}

/// A lamp that closes the ball's top: a disc gives as much as the cap over it. It reflects as the wall does.
#[test]
fn a_white_room_with_bounces_is_an_integrating_sphere() {
    let open = 12.0_f64.to_radians();
    let share = (1.0 - open.cos()) / 2.0;
    let mut scene = bowl_scene(open);
    scene.materials.push(Material { emission: Vec3::splat(40.0), ..scene.materials[0].clone() });
    let rim = |sector: usize| {
        let around = 2.0 * PI * sector as f64 / 96.0;
        DVec3::new(open.sin() * around.cos(), open.cos(), open.sin() * around.sin()).as_vec3()
    };
    let middle = Vec3::Y * open.cos() as f32;
    let disc: Vec<[Vec3; 3]> = (0..96).map(|sector| [middle, rim(sector), rim(sector + 1)]).collect();
    add(&mut scene, Mesh { material: 1, ..triangles(&disc) });
    // What is lost is lost again with each bounce.
    expect_in_ball(&scene, 40.0 * PI * share, 0.0, 0.025);
}
