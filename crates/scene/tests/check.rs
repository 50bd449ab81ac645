//! Scenes made in memory: what they must not be.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{DQuat, DVec3, Vec2, Vec3, Vec4};
use voxlume_fault::Source;
use voxlume_scene::{Animation, Key, LightKind, Moved, Path, Scene, TextureRef};

fn scene() -> Scene {
    Scene::parse(&Source::new(
        "a.ron",
        r#"(materials: {"m": ()},
            objects: [(name: "box", shape: Box(), material: "m")],
            lights: [Spot(name: "spot", position: (0, 2, 0), direction: (0, -1, 0), intensity: 1, outer_deg: 30)],
            cameras: [(name: "front", eye: (0, 0, 3), target: (0, 0, 0), fov_deg: 45)])"#,
    ))
    .unwrap()
}

fn message(change: impl FnOnce(&mut Scene)) -> String {
    let mut scene = scene();
    change(&mut scene);
    scene.check().unwrap_err().to_string()
}

#[test]
fn a_loaded_scene_is_right() {
    scene().check().unwrap();
    Scene::default().check().unwrap();
}

/// The whole message of each.
#[test]
fn each_part_is_checked() {
    type Change = fn(&mut Scene);
    let cases: [(Change, &str); 28] = [
        (|s| s.meshes[0].positions[5].y = f32::NAN, "mesh 0, `box`: the position of vertex 5 is not finite"),
        (|s| s.meshes[0].normals[1] = Vec3::NAN, "mesh 0, `box`: the normal of vertex 1 is not finite"),
        (|s| s.meshes[0].tangents[1].w = f32::NAN, "mesh 0, `box`: the tangent of vertex 1 is not finite"),
        (
            |s| s.meshes[0].uvs[23] = Vec2::INFINITY,
            "mesh 0, `box`: the texture coordinate of vertex 23 is not finite",
        ),
        (|s| s.meshes[0].triangles[3][2] = 24, "mesh 0, `box`: triangle 3 names a vertex beyond the 24"),
        (|s| s.meshes[0].material = 1, "mesh 0, `box`: it names material 1 of 1"),
        (|s| s.meshes[0].uvs.truncate(3), "mesh 0, `box`: its attributes differ in length"),
        (|s| s.instances[0].mesh = 7, "instance 0, `box`: it names mesh 7 of 1"),
        (
            |s| s.instances[0].transform.translation.z = f64::INFINITY,
            "instance 0, `box`: its transform is not finite",
        ),
        (|s| s.instances[0].transform.translation.z = 1e16, "`box` reaches beyond 1e15 units"),
        (
            |s| s.materials[0].base_color = Vec4::splat(1.5),
            "material 0, `m`: `base_color` must be from 0 to 1",
        ),
        (|s| s.materials[0].roughness = f32::NAN, "material 0, `m`: `roughness` must be from 0 to 1"),
        (|s| s.materials[0].normal_scale = f32::NAN, "material 0, `m`: `normal_scale` must be finite"),
        (|s| s.materials[0].emission.x = -1.0, "material 0, `m`: `emission` must be finite and at least 0"),
        (
            |s| s.materials[0].alpha_cutoff = Some(f32::NAN),
            "material 0, `m`: `alpha_cutoff` must be finite and at least 0",
        ),
        (
            |s| s.materials[0].normal_texture = Some(TextureRef { texture: 0 }),
            "material 0, `m`: it names texture 0 of 0",
        ),
        (
            |s| {
                s.textures.push(voxlume_scene::Texture {
                    name: "t".into(),
                    width: 2,
                    height: 2,
                    rgba: vec![0; 15],
                    srgb: true,
                });
            },
            "texture 0, `t`: it has other than width × height texels",
        ),
        (
            |s| s.lights[0].intensity = Vec3::INFINITY,
            "light 0, `spot`: `intensity` must be finite and at least 0",
        ),
        (|s| set_spot(s, |position, _, _, _| *position = DVec3::NAN), "`spot` lies beyond 1e15 units"),
        (
            |s| set_spot(s, |_, direction, _, _| *direction = Vec3::ZERO),
            "light 0, `spot`: `direction` must be of length 1",
        ),
        (
            |s| set_spot(s, |_, _, radius, _| *radius = -1.0),
            "light 0, `spot`: `radius` must be finite and at least 0",
        ),
        (
            |s| set_spot(s, |_, _, _, outer| *outer = 2.0),
            "light 0, `spot`: the outer angle must be above 0° and at most 90°",
        ),
        (|s| s.cameras[0].eye.x = f64::NAN, "`front` lies beyond 1e15 units"),
        (|s| s.cameras[0].up = Vec3::Z, "camera 0, `front`: `forward` and `up` must be at right angles"),
        (
            |s| s.cameras[0].vertical_fov = 4.0,
            "camera 0, `front`: `vertical_fov` must be above 0° and below 180°",
        ),
        (|s| s.sky.x = f32::NAN, "`sky` must be finite and at least 0"),
        (
            |s| {
                let rest = s.instances[0].transform;
                let moved = Moved { index: 3, rest, path: Path { keys: vec![] } };
                s.animation = Animation { instances: vec![moved], ..Animation::default() };
            },
            "a path moves instance 3, of which there are 1",
        ),
        (
            |s| {
                let keys = vec![Key {
                    time: 0.0,
                    scale: DVec3::ONE,
                    rotation: DQuat::IDENTITY,
                    translation: DVec3::NAN,
                }];
                let moved = Moved { index: 0, rest: s.lights[0].kind, path: Path { keys } };
                s.animation = Animation { lights: vec![moved], ..Animation::default() };
            },
            "the path of light 0 is not finite",
        ),
    ];
    for (change, expected) in cases {
        assert_eq!(message(change), format!("error: {expected}"));
    }
}

fn set_spot(scene: &mut Scene, change: fn(&mut DVec3, &mut Vec3, &mut f32, &mut f32)) {
    let LightKind::Spot { position, direction, radius, outer, .. } = &mut scene.lights[0].kind else {
        panic!("a spot")
    };
    change(position, direction, radius, outer);
}

/// All parts' faults at once.
#[test]
fn all_faults_are_told() {
    let message = message(|scene| {
        scene.meshes[0].positions[0].x = f32::NAN;
        scene.sky.y = -1.0;
    });
    assert_eq!(message.matches("error:").count(), 2, "{message}");
}
