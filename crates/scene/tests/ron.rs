//! RON scenes: what they become, and the whole message of each fault.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::{Builder, Folder};
use glam::{DVec3, Vec3, Vec4};
use insta::assert_snapshot;
use voxlume_scene::{Geometry, LightKind, Scene};

fn load(text: &str) -> Result<Scene, String> {
    let folder = Folder::new();
    folder.write("a.ron", text);
    folder.load("a.ron")
}

fn fault(text: &str) -> String {
    load(text).expect_err("it should be refused")
}

#[test]
fn the_documentations_example() {
    let folder = Folder::new();
    folder.write("a.ron", include_str!("../src/ron/example.ron"));
    Builder::triangle().load_gltf(&folder, "model.gltf").unwrap();
    let scene = folder.load("a.ron").unwrap();

    let names: Vec<_> = scene.instances.iter().map(|i| (i.name.as_str(), i.moving)).collect();
    assert_eq!(names, [("object 0", false), ("ball", true), ("object 2", false), ("object 3/node 0", false)]);
    assert_eq!(
        scene.materials.iter().map(|m| m.name.as_str()).collect::<Vec<_>>(),
        ["white", "gold", "lamp", "default"]
    );
    assert_eq!(scene.materials[1].base_color, Vec4::new(1.0, 0.71, 0.29, 1.0));
    assert_eq!((scene.materials[1].metallic, scene.materials[1].roughness), (1.0, 0.2));
    assert_eq!(scene.materials[2].emission, Vec3::new(12.0, 10.0, 8.0));
    assert_eq!((scene.name.as_str(), scene.sky), ("a", Vec3::new(0.2, 0.3, 0.5)));

    // The lamp is turned to face down; the model is scaled, turned about y and moved.
    let geometry = Geometry::new(&scene, DVec3::ZERO);
    let lamp: Vec<_> = (0..geometry.positions.len()).filter(|i| geometry.materials[*i] == 2).collect();
    assert!(lamp.iter().all(|i| geometry.normals[*i].abs_diff_eq(-Vec3::Y, 1e-6)));
    // The ball, which may move, comes after it.
    let still = geometry.positions.len() - Geometry::moving(&scene, DVec3::ZERO).positions.len();
    let corner = geometry.positions[still - 2];
    let s = 2.0_f32.sqrt();
    assert!(corner.abs_diff_eq(Vec3::new(2.0 + s, 0.0, -s), 1e-5), "{corner}");

    let [sun, point, spot] = &scene.lights[..] else { panic!() };
    let LightKind::Directional { direction, angular_diameter } = sun.kind else { panic!() };
    assert!(direction.abs_diff_eq(Vec3::new(-1.0, -2.0, -1.0).normalize(), 1e-6));
    assert!((angular_diameter.to_degrees() - 0.53).abs() < 1e-6);
    assert_eq!(sun.intensity, Vec3::new(3.0, 2.9, 2.7));
    assert_eq!(point.kind, LightKind::Point { position: DVec3::splat(2.0), radius: 0.1 });
    assert_eq!(point.intensity, Vec3::splat(5.0));
    assert!(matches!(spot.kind, LightKind::Spot { inner, outer, .. }
        if (inner.to_degrees() - 20.0).abs() < 1e-4 && (outer.to_degrees() - 30.0).abs() < 1e-4));

    let camera = &scene.cameras[0];
    assert_eq!((camera.name.as_str(), camera.eye), ("front", DVec3::new(0.0, 2.0, 6.0)));
    assert!(camera.forward.abs_diff_eq(Vec3::new(0.0, -1.5, -6.0).normalize(), 1e-6));
    assert!(camera.up.dot(camera.forward).abs() < 1e-6 && camera.up.y > 0.9);
}

#[test]
fn transforms() {
    let place = |transform: &str| {
        let text = format!(
            "(materials: {{\"m\": ()}}, objects: [(shape: Triangle(corners: [(1, 0, 0), (0, 1, 0), (0, 0, 1)]), material: \"m\", {transform})])"
        );
        Geometry::new(&load(&text).unwrap(), DVec3::ZERO).positions
    };
    let near = |transform: &str, expected: [Vec3; 3]| {
        let found = place(transform);
        assert!(found.iter().zip(expected).all(|(f, e)| f.abs_diff_eq(e, 1e-6)), "{transform}: {found:?}");
    };
    let (x, y, z) = (Vec3::X, Vec3::Y, Vec3::Z);
    near("", [x, y, z]);
    near("rotate_deg: (90, 0, 0)", [x, z, -y]);
    // First about x, then about z.
    near("rotate_deg: (90, 0, 90)", [y, z, x]);
    near(
        "scale: (2, 3, 4), rotate_deg: (0, 90, 0), translate: (1, 1, 1)",
        [x + y + z - 2.0 * z, x + 4.0 * y + z, x + y + z + 4.0 * x],
    );
    near(
        "matrix: [(1, 0, 0, 5), (0, 2, 0, 6), (0, 0, -1, 7)]",
        [Vec3::new(6., 6., 7.), Vec3::new(5., 8., 7.), Vec3::new(5., 6., 6.)],
    );
    // Far from the origin nothing is lost that the caller takes off again.
    let far = load(
        "(materials: {\"m\": ()}, objects: [(shape: Box(), material: \"m\", translate: (1e6, 0, 0.001))])",
    )
    .unwrap();
    let geometry = Geometry::new(&far, DVec3::new(1e6, 0.0, 0.0));
    assert!(
        (geometry.positions[0].z.abs() - 0.5).abs() < 0.0010001
            && geometry.positions.iter().all(|p| p.z != 0.5)
    );
}

#[test]
fn gltf_objects_share_files_and_take_materials() {
    let folder = Folder::new();
    let mut model = Builder::triangle();
    model.json["nodes"] = serde_json::json!([{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0}]);
    folder.write("models/a.glb", model.glb());
    folder.write(
        "scenes/a.ron",
        r#"(materials: {"m": ()}, objects: [
            (gltf: "../models/a.glb"), (gltf: "../models/a.glb", translate: (1, 0, 0), moving: true),
            (gltf: "../models/a.glb", material: "m"),
        ])"#,
    );
    let scene = folder.load("scenes/a.ron").unwrap();
    assert_eq!((scene.instances.len(), scene.meshes.len(), scene.materials.len()), (6, 2, 2));
    let materials: Vec<_> = scene
        .instances
        .iter()
        .map(|i| scene.materials[scene.meshes[i.mesh].material].name.as_str())
        .collect();
    assert_eq!(materials, ["default", "default", "default", "default", "m", "m"]);
    assert_eq!((scene.sky, scene.lights.len()), (Vec3::ZERO, 0));
    assert!(scene.instances[2].moving && scene.instances[3].transform.translation == DVec3::X);
}

#[test]
fn all_faults_at_once() {
    assert_snapshot!(fault(r#"(
    materials: {
        "white": (base_colour: (1, 1, 1), roughness: 1.5),
        "white": (base_color: (1, 2, 3, 4)),
        "lamp": (emission: (NaN, 0, 0)),
    },
    objects: [
        (shape: Sphere(radius: -1, segments: 2), material: "whit"),
        (shape: Spere(), material: "white"),
        (shape: Box(min: (0, 0)), gltf: "a.glb", translte: (1, 2, 3)),
        (gltf: "none.glb", scale: "big"),
        (shape: Quad(), inside_out: 1),
    ],
    lights: [
        Point(position: (0, inf, 0)),
        Sun(direction: (0, 0, 0)),
        Directional(direction: (0, 0, 0), irradiance: -1, angular_diameter_deg: 180),
        Spot(position: (0, 0, 0), direction: (0, -1, 0), intensity: 1, inner_deg: 50, outer_deg: 40),
    ],
    sky: "blue",
    camera: [],
    cameras: [(eye: (0, 0, 0), target: (0, 0, 0), fov_deg: 45), (eye: (0, 0, 0), target: (0, 0, 1), fov_deg: 200)],
)"#), @r#"
    error: unknown field `base_colour`
      ┌─ DIR/a.ron:3:19
      │
    3 │         "white": (base_colour: (1, 1, 1), roughness: 1.5),
      │                   ^^^^^^^^^^^ did you mean `base_color`? one of: base_color, metallic, roughness, emission, alpha_cutoff, double_sided

    error: `roughness` must be from 0 to 1
      ┌─ DIR/a.ron:3:54
      │
    3 │         "white": (base_colour: (1, 1, 1), roughness: 1.5),
      │                                                      ^^^

    error: material `white` given twice
      ┌─ DIR/a.ron:4:9
      │
    4 │         "white": (base_color: (1, 2, 3, 4)),
      │         ^^^^^^^ the second

    error: `base_color` must be from 0 to 1
      ┌─ DIR/a.ron:4:31
      │
    4 │         "white": (base_color: (1, 2, 3, 4)),
      │                               ^

    error: expected a finite number, found `NaN`
      ┌─ DIR/a.ron:5:29
      │
    5 │         "lamp": (emission: (NaN, 0, 0)),
      │                             ^^^

    error: `radius` must be above 0
      ┌─ DIR/a.ron:8:32
      │
    8 │         (shape: Sphere(radius: -1, segments: 2), material: "whit"),
      │                                ^^

    error: `segments` must be from 3 to 2048
      ┌─ DIR/a.ron:8:46
      │
    8 │         (shape: Sphere(radius: -1, segments: 2), material: "whit"),
      │                                              ^

    error: unknown material `whit`
      ┌─ DIR/a.ron:8:60
      │
    8 │         (shape: Sphere(radius: -1, segments: 2), material: "whit"),
      │                                                            ^^^^^^ did you mean `white`? one of: white, lamp

    error: unknown shape `Spere`
      ┌─ DIR/a.ron:9:17
      │
    9 │         (shape: Spere(), material: "white"),
      │                 ^^^^^ did you mean `Sphere`? one of: Box, Quad, Grid, Disc, Cylinder, Sphere, Triangle, Triangles

    error: an object has either `shape` or `gltf`
       ┌─ DIR/a.ron:10:9
       │
    10 │         (shape: Box(min: (0, 0)), gltf: "a.glb", translte: (1, 2, 3)),
       │         ^ both are given

    error: unknown field `translte`
       ┌─ DIR/a.ron:10:50
       │
    10 │         (shape: Box(min: (0, 0)), gltf: "a.glb", translte: (1, 2, 3)),
       │                                                  ^^^^^^^^ did you mean `translate`? one of: name, moving, scale, rotate_deg, translate, matrix, path, material, shape, gltf, inside_out

    error: cannot read `DIR/none.glb`: no such file
       ┌─ DIR/a.ron:11:16
       │
    11 │         (gltf: "none.glb", scale: "big"),
       │                ^^^^^^^^^^ read from here

    error: expected a number, found a string
       ┌─ DIR/a.ron:11:35
       │
    11 │         (gltf: "none.glb", scale: "big"),
       │                                   ^^^^^

    error: missing field `material`
       ┌─ DIR/a.ron:12:9
       │
    12 │         (shape: Quad(), inside_out: 1),
       │         ^ a shape needs one

    error: missing field `corners` of `Quad`
       ┌─ DIR/a.ron:12:17
       │
    12 │         (shape: Quad(), inside_out: 1),
       │                 ^^^^ needed here

    error: expected `true` or `false`, found `1`
       ┌─ DIR/a.ron:12:37
       │
    12 │         (shape: Quad(), inside_out: 1),
       │                                     ^

    error: missing field `intensity` of `Point`
       ┌─ DIR/a.ron:15:9
       │
    15 │         Point(position: (0, inf, 0)),
       │         ^^^^^ needed here

    error: expected a finite number, found `inf`
       ┌─ DIR/a.ron:15:29
       │
    15 │         Point(position: (0, inf, 0)),
       │                             ^^^

    error: unknown light `Sun`
       ┌─ DIR/a.ron:16:9
       │
    16 │         Sun(direction: (0, 0, 0)),
       │         ^^^ one of: Directional, Point, Spot

    error: `direction` has no length
       ┌─ DIR/a.ron:17:32
       │
    17 │         Directional(direction: (0, 0, 0), irradiance: -1, angular_diameter_deg: 180),
       │                                ^

    error: `irradiance` must be finite and at least 0
       ┌─ DIR/a.ron:17:55
       │
    17 │         Directional(direction: (0, 0, 0), irradiance: -1, angular_diameter_deg: 180),
       │                                                       ^^

    error: `angular_diameter_deg` must be at least 0° and below 180°
       ┌─ DIR/a.ron:17:81
       │
    17 │         Directional(direction: (0, 0, 0), irradiance: -1, angular_diameter_deg: 180),
       │                                                                                 ^^^

    error: the inner angle must be at least 0° and below the outer angle
       ┌─ DIR/a.ron:18:9
       │
    18 │         Spot(position: (0, 0, 0), direction: (0, -1, 0), intensity: 1, inner_deg: 50, outer_deg: 40),
       │         ^^^^ its `inner_deg` and `outer_deg`

    error: expected a number, found a string
       ┌─ DIR/a.ron:20:10
       │
    20 │     sky: "blue",
       │          ^^^^^^

    error: unknown field `camera`
       ┌─ DIR/a.ron:21:5
       │
    21 │     camera: [],
       │     ^^^^^^ did you mean `cameras`? one of: materials, objects, lights, cameras, sky

    error: no view: `eye` is at `target`, or `up` points along the view
       ┌─ DIR/a.ron:22:15
       │
    22 │     cameras: [(eye: (0, 0, 0), target: (0, 0, 0), fov_deg: 45), (eye: (0, 0, 0), target: (0, 0, 1), fov_deg: 200)],
       │               ^

    error: `fov_deg` must be above 0° and below 180°
       ┌─ DIR/a.ron:22:110
       │
    22 │     cameras: [(eye: (0, 0, 0), target: (0, 0, 0), fov_deg: 45), (eye: (0, 0, 0), target: (0, 0, 1), fov_deg: 200)],
       │                                                                                                              ^^^
    "#);
}

#[test]
fn single_faults() {
    assert_snapshot!(fault("(lights: [Point(name: \"far\", position: (1e16, 0, 0), intensity: 1)])"), @r#"
    error: `DIR/a.ron`: `far` lies beyond 1e15 units
    "#);
    assert_snapshot!(fault("(objects: [(shape: Box() material: \"m\")])"), @r#"
    error: expected comma
      ┌─ DIR/a.ron:1:26
      │
    1 │ (objects: [(shape: Box() material: "m")])
      │                          ^
    "#);
    assert_snapshot!(fault("[]"), @r#"
    error: expected fields `(name: value, ...)`, found a list
      ┌─ DIR/a.ron:1:1
      │
    1 │ []
      │ ^
    "#);
    assert_snapshot!(fault("(objects: [Box()])"), @r#"
    error: unexpected name `Box`
      ┌─ DIR/a.ron:1:12
      │
    1 │ (objects: [Box()])
      │            ^^^ only `(name: value, ...)` goes here
    "#);
    assert_snapshot!(fault(r#"(materials: {"m": ()}, objects: [(material: "m", shape: Triangles(
        positions: [(0, 0, 0), (1, 0, 0), (0, 1, 0)],
        indices: [(0, 1, 2), (0, 1, 3)],
    ))])"#), @r#"
    error: index out of range
      ┌─ DIR/a.ron:3:30
      │
    3 │         indices: [(0, 1, 2), (0, 1, 3)],
      │                              ^ there are 3 positions
    "#);
    assert_snapshot!(fault(r#"(materials: {"m": ()}, objects: [(material: "m", shape: Grid(cells: (100000, 100000)), matrix: [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)], scale: 2)])"#), @r#"
    error: `cells` must be at least 1 and together at most 4000000
      ┌─ DIR/a.ron:1:69
      │
    1 │ (materials: {"m": ()}, objects: [(material: "m", shape: Grid(cells: (100000, 100000)), matrix: [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)], scale: 2)])
      │                                                                     ^

    error: `matrix` goes without `scale`, `rotate_deg` and `translate`
      ┌─ DIR/a.ron:1:96
      │
    1 │ (materials: {"m": ()}, objects: [(material: "m", shape: Grid(cells: (100000, 100000)), matrix: [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)], scale: 2)])
      │                                                                                                ^
    "#);
    assert_snapshot!(fault(r#"(materials: {"m": ()}, objects: [(name: "far", material: "m", shape: Box(), translate: (1e16, 0, 0))])"#), @"error: `DIR/a.ron`: `far` reaches beyond 1e15 units");
    assert_snapshot!(fault(r#"(materials: {"m": ()}, objects: [(name: "wild", material: "m", shape: Box(), scale: 1e300)])"#), @"error: `DIR/a.ron`: `wild` reaches beyond 1e15 units");
}
