//! Paths: where they take things, how far they reach, and the whole message of each fault.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::Folder;
use glam::{DVec3, Vec3};
use voxlume_scene::{Geometry, LightKind, Scene};

fn load(text: &str) -> Result<Scene, String> {
    let folder = Folder::new();
    folder.write("a.ron", text);
    folder.load("a.ron")
}

fn scene(fields: &str) -> Scene {
    load(&format!(
        "(materials: {{\"m\": ()}}, objects: [(shape: Box(), material: \"m\", {fields}), (shape: Box(), material: \"m\")])"
    ))
    .unwrap_or_else(|message| panic!("{message}"))
}

#[test]
fn objects_follow_their_keys() {
    let mut scene = scene(
        "translate: (0, -2, 0), path: [(time: 1), (time: 3, translate: (4, 0, 0), rotate_deg: (0, 0, 90), scale: 3)]",
    );
    assert!(scene.instances[0].moving && !scene.instances[1].moving);
    let mut at = |time: f64, p: [f64; 3]| {
        scene.set_time(time);
        scene.instances[0].transform.transform_point3(DVec3::from(p))
    };
    let near = |found: DVec3, expected: [f64; 3]| {
        assert!(found.abs_diff_eq(DVec3::from(expected), 1e-9), "{found}, not {expected:?}");
    };
    // Before the first key and after the last it rests; the pose comes after the object's own place.
    near(at(-5.0, [0.0; 3]), [0.0, -2.0, 0.0]);
    near(at(1.0, [1.0, 0.0, 0.0]), [1.0, -2.0, 0.0]);
    near(at(3.0, [0.0; 3]), [4.0 + 6.0, 0.0, 0.0]);
    near(at(99.0, [0.0; 3]), [10.0, 0.0, 0.0]);
    // Half-way: twice as large, turned by 45°, moved by 2.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    near(at(2.0, [0.0; 3]), [2.0 + 4.0 * half, -4.0 * half, 0.0]);
    near(at(0.0, [0.0; 3]), [0.0, -2.0, 0.0]);
}

#[test]
fn lights_and_cameras_follow_theirs() {
    let mut scene = load(
        "(
            lights: [
                Spot(position: (0, -1, 0), direction: (0, -1, 0), intensity: 1, path: [(time: 0), (time: 1, translate: (0, 3, 0), rotate_deg: (0, 0, 90))]),
                Directional(direction: (0, 0, -1), irradiance: 1, path: [(time: 0, rotate_deg: (0, 90, 0))]),
                Point(position: (1, 2, 3), intensity: 1),
            ],
            cameras: [(eye: (0, 0, 5), target: (0, 0, 0), fov_deg: 45, path: [(time: 0), (time: 2, rotate_deg: (0, 90, 0))])],
        )",
    )
    .unwrap();
    scene.set_time(1.0);
    let LightKind::Spot { position, direction, .. } = scene.lights[0].kind else { panic!() };
    assert!(position.abs_diff_eq(DVec3::new(1.0, 3.0, 0.0), 1e-9) && direction.abs_diff_eq(Vec3::X, 1e-6));
    let LightKind::Directional { direction, .. } = scene.lights[1].kind else { panic!() };
    assert!(direction.abs_diff_eq(-Vec3::X, 1e-6));
    assert!(
        matches!(scene.lights[2].kind, LightKind::Point { position, .. } if position == DVec3::new(1.0, 2.0, 3.0))
    );
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let camera = &scene.cameras[0];
    assert!(camera.eye.abs_diff_eq(DVec3::new(5.0 * half, 0.0, 5.0 * half), 1e-9));
    assert!(
        camera.forward.as_dvec3().abs_diff_eq(-camera.eye / 5.0, 1e-6)
            && camera.up.abs_diff_eq(Vec3::Y, 1e-6)
    );
}

/// Nothing ever leaves the box that the grid is fitted to, and the box is hardly larger than it has to be.
#[test]
fn the_reach_holds_the_whole_path() {
    for path in [
        "(time: 0), (time: 1, translate: (5, 1, -2))",
        "(time: 0, rotate_deg: (0, 0, -80)), (time: 1, rotate_deg: (0, 0, 80))",
        "(time: 0, scale: 0.1), (time: 1, rotate_deg: (90, 100, 30), translate: (1, 2, 3), scale: (2, 1, 3)), (time: 3)",
    ] {
        let mut scene = scene(&format!("translate: (0, -3, 0), path: [{path}]"));
        let (low, high) = scene.reach().unwrap();
        let (mut least, mut most) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for step in 0..=3000 {
            scene.set_time(f64::from(step) / 1000.0);
            let (l, h) = scene.bounds().unwrap();
            assert!(
                l.cmpge(low).all() && h.cmple(high).all(),
                "{path}: at {step} ms {l} to {h}, reach {low} to {high}"
            );
            (least, most) = (least.min(l), most.max(h));
        }
        let slack = (least - low).max(high - most).max_element();
        assert!(slack < 0.03, "{path}: {slack}");
    }
}

#[test]
fn triangles_that_move_come_last() {
    let mut scene = scene("path: [(time: 0), (time: 1, translate: (9, 0, 0))]");
    scene.set_time(1.0);
    let geometry = Geometry::new(&scene, DVec3::ZERO);
    let moving = Geometry::moving(&scene, DVec3::ZERO);
    assert_eq!(moving.positions.len() * 2, geometry.positions.len());
    assert_eq!(geometry.positions[moving.positions.len()..], moving.positions);
    assert!(moving.positions.iter().all(|p| p.x > 8.0));
}

fn fault(path: &str) -> String {
    load(&format!(
        "(\n    materials: {{\"m\": ()}},\n    objects: [(shape: Box(), material: \"m\", path: {path})],\n)"
    ))
    .expect_err("it should be refused")
}

#[test]
fn faults_of_paths() {
    insta::assert_snapshot!(fault("[]"), @r#"
    error: a path without keys
      ┌─ DIR/a.ron:3:51
      │
    3 │     objects: [(shape: Box(), material: "m", path: [])],
      │                                                   ^ `(time: seconds, translate: (x, y, z), ...)`
    "#);
    insta::assert_snapshot!(fault("[(translate: (1, 2, 3))]"), @r#"
    error: missing field `time`
      ┌─ DIR/a.ron:3:52
      │
    3 │     objects: [(shape: Box(), material: "m", path: [(translate: (1, 2, 3))])],
      │                                                    ^ needed here
    "#);
    insta::assert_snapshot!(fault("[(time: 1), (time: 1)]"), @r#"
    error: times must rise
      ┌─ DIR/a.ron:3:70
      │
    3 │     objects: [(shape: Box(), material: "m", path: [(time: 1), (time: 1)])],
      │                                                                      ^ above 1
    "#);
    insta::assert_snapshot!(fault("[(time: 0), (time: 1, rotate_deg: (0, 360, 0))]"), @r#"
    error: a turn by 180° or more between two keys
      ┌─ DIR/a.ron:3:85
      │
    3 │     objects: [(shape: Box(), material: "m", path: [(time: 0), (time: 1, rotate_deg: (0, 360, 0))])],
      │                                                                                     ^ put a key in between
    "#);
    insta::assert_snapshot!(fault("[(time: 0, scale: (1, 0, 1))]"), @r#"
    error: `scale` must not be 0, nor pass through it
      ┌─ DIR/a.ron:3:69
      │
    3 │     objects: [(shape: Box(), material: "m", path: [(time: 0, scale: (1, 0, 1))])],
      │                                                                     ^
    "#);
    insta::assert_snapshot!(fault("[(time: 0), (time: 1, scale: -1)]"), @r#"
    error: `scale` must not be 0, nor pass through it
      ┌─ DIR/a.ron:3:80
      │
    3 │     objects: [(shape: Box(), material: "m", path: [(time: 0), (time: 1, scale: -1)])],
      │                                                                                ^^
    "#);
    insta::assert_snapshot!(fault("[(time: 0, position: (1, 2, 3))]"), @r#"
    error: unknown field `position`
      ┌─ DIR/a.ron:3:62
      │
    3 │     objects: [(shape: Box(), material: "m", path: [(time: 0, position: (1, 2, 3))])],
      │                                                              ^^^^^^^^ one of: time, scale, rotate_deg, translate
    "#);
    insta::assert_snapshot!(fault("[(time: 0), (time: 1, translate: (1e99, 0, 0))]"), @"error: `DIR/a.ron`: the path of `object 0` reaches beyond 1e15 units");
    let light = load("(lights: [Point(position: (0, 0, 0), intensity: 1, path: [(time: 0, scale: 2)])])");
    insta::assert_snapshot!(light.expect_err("a light has no size"), @r#"
    error: unknown field `scale`
      ┌─ DIR/a.ron:1:69
      │
    1 │ (lights: [Point(position: (0, 0, 0), intensity: 1, path: [(time: 0, scale: 2)])])
      │                                                                     ^^^^^ one of: time, rotate_deg, translate
    "#);
}
