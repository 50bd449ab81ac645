//! Random triangles, transforms, materials, lights and cameras: finite images, no complaint of the device, and the
//! occupancy of the exact model in `f64`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{DAffine3, DMat3, DQuat, DVec3, EulerRot, Vec3, Vec4};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use voxlume::scene::{Instance, Light, LightKind, Material, Texture, TextureRef};
use voxlume::{Camera, Formats, Passes, Renderer, Request, ResourceKind, Scene, Value};
use voxlume_tests::{
    EPSILON, Separability, Substrate, compare, gi, gpu, picture, plan_for, scene_of, span, triangles,
};

/// The same cases in every run; a case is half a second on a software device.
fn config(cases: u32) -> Config {
    Config {
        cases,
        rng_seed: RngSeed::Fixed(7),
        failure_persistence: None,
        max_shrink_iters: 30,
        ..Config::default()
    }
}

/// Numbers of any order of magnitude, and those that break divisions.
fn wild() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        4 => -10.0..10.0f64,
        2 => (-12.0..6.0f64, prop::sample::select(vec![-1.0, 1.0])).prop_map(|(power, sign)| 10f64.powf(power) * sign),
        1 => Just(0.0),
        1 => Just(1.0),
    ]
}

fn point(number: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = DVec3> {
    [number.clone(), number.clone(), number].prop_map(DVec3::from)
}

fn direction() -> impl Strategy<Value = Vec3> {
    point(-1.0..1.0f64).prop_map(|v| v.try_normalize().unwrap_or(DVec3::Y).as_vec3())
}

fn colour() -> impl Strategy<Value = Vec3> {
    prop_oneof![
        4 => [0.0..4.0f32, 0.0..4.0, 0.0..4.0].prop_map(Vec3::from),
        1 => (-7.0..5.0f32).prop_map(|power| Vec3::splat(10f32.powf(power))),
        1 => Just(Vec3::ZERO),
    ]
}

fn transform() -> impl Strategy<Value = DAffine3> {
    (point(wild()), point(-3.2..3.2f64), point(-8.0..8.0f64)).prop_map(|(scale, turn, translation)| {
        // Flattened and mirrored, but no larger than the scene.
        let scale = scale.clamp(DVec3::splat(-3.0), DVec3::splat(3.0));
        let rotation = DMat3::from_quat(DQuat::from_euler(EulerRot::XYZ, turn.x, turn.y, turn.z));
        DAffine3::from_mat3_translation(rotation * DMat3::from_diagonal(scale), translation)
    })
}

fn material() -> impl Strategy<Value = Material> {
    let part = || prop_oneof![3 => 0.0..=1.0f32, 1 => Just(0.0f32), 1 => Just(1.0f32)];
    let emission = prop_oneof![2 => Just(Vec3::ZERO), 1 => colour()];
    // Of the scene's two textures, colours and data.
    let texture = |texture| prop::option::of(Just(TextureRef { texture }));
    let textures = (texture(0), texture(0), texture(1), texture(1), -4.0..4.0f32);
    ([part(), part(), part()], part(), part(), emission, any::<bool>(), any::<bool>(), textures).prop_map(
        |(color, metallic, roughness, emission, double_sided, masked, textures)| Material {
            base_color: Vec4::new(color[0], color[1], color[2], 1.0),
            base_color_texture: textures.0,
            metallic,
            roughness,
            metallic_roughness_texture: textures.2,
            normal_texture: textures.3,
            normal_scale: textures.4,
            emission,
            emission_texture: textures.1,
            double_sided,
            alpha_cutoff: masked.then_some(0.5),
            ..Material::default()
        },
    )
}

fn light() -> impl Strategy<Value = Light> {
    let size = || prop_oneof![Just(0.0f32), 0.0..2.0f32, Just(1e3f32)];
    let kind = prop_oneof![
        (direction(), 0.0..std::f32::consts::PI)
            .prop_map(|(direction, angular_diameter)| LightKind::Directional { direction, angular_diameter }),
        (point(wild()), size()).prop_map(|(position, radius)| LightKind::Point { position, radius }),
        (point(wild()), direction(), size(), 0.01..1.57f32).prop_map(
            |(position, direction, radius, outer)| {
                LightKind::Spot { position, direction, radius, inner: outer * 0.5, outer }
            }
        ),
    ];
    (kind, colour()).prop_map(|(kind, intensity)| Light { name: "light".into(), kind, intensity })
}

fn triangle(number: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = [Vec3; 3]> {
    [point(number.clone()), point(number.clone()), point(number)]
        .prop_map(|corners| corners.map(|c| c.as_vec3()))
}

prop_compose! {
    fn scene()(
        materials in prop::collection::vec(material(), 1..4),
        meshes in prop::collection::vec(prop::collection::vec(triangle(wild()), 0..12), 0..4),
        transforms in prop::collection::vec(transform(), 4),
        lights in prop::collection::vec(light(), 0..6),
        sky in colour(),
        (eye, target) in (point(-20.0..20.0f64), point(-5.0..5.0f64)),
        fov in 0.05..3.0f32,
        texels in prop::collection::vec(any::<u8>(), 2 * 4 * 4 * 4),
        uv_scale in wild(),
    ) -> Scene {
        let camera = Camera::look_at("any", eye, target, DVec3::new(0.01, 1.0, 0.02), fov);
        let mut scene = Scene { materials, lights, sky, ..scene_of(Vec::new(), 1.0) };
        for (rgba, srgb) in texels.chunks_exact(4 * 4 * 4).zip([true, false]) {
            scene.textures.push(Texture { name: "noise".into(), width: 4, height: 4, rgba: rgba.to_vec(), srgb });
        }
        scene.cameras = camera.into_iter().chain(scene.cameras.drain(..)).collect();
        for (index, list) in meshes.iter().enumerate() {
            let mut mesh = triangles(list);
            mesh.material = index % scene.materials.len();
            mesh.uvs = mesh.positions.iter().map(|p| p.truncate() * uv_scale as f32).collect();
            scene.instances.push(Instance {
                name: "soup".into(),
                mesh: index,
                transform: transforms[index],
                moving: false,
            });
            scene.meshes.push(mesh);
        }
        scene
    }
}

/// Renders all that there is, and looks at all of it.
fn check(scene: &Scene, format: &str, output: &str) -> Result<(), TestCaseError> {
    let request = Request {
        format: Some(format.into()),
        resolution: Some(16),
        output: Some(output.into()),
        set: vec![
            ("composite".into(), "ao_weight".into(), Value::Number(0.5)),
            ("bounce".into(), "bounces".into(), Value::Number(1.0)),
        ],
        ..Request::image(17, 9)
    };
    let plan = plan_for(&gi(), scene, &request);
    let mut renderer =
        Renderer::new(gpu(), plan, scene).map_err(|error| TestCaseError::fail(error.to_string()))?;
    renderer
        .render(scene, &scene.cameras[0], Passes::All)
        .map_err(|error| TestCaseError::fail(error.to_string()))?;
    let resources: Vec<_> =
        renderer.plan().resources.iter().map(|r| (r.name.clone(), r.kind.clone())).collect();
    for (name, kind) in resources {
        let finite = match kind {
            ResourceKind::Image { .. } => {
                picture(&renderer, &name).pixels.iter().flatten().all(|value| value.is_finite())
            }
            ResourceKind::Volume { .. } => {
                let levels = renderer.volume(&name).unwrap();
                levels.iter().flat_map(|level| &level.values).flatten().all(|value| value.is_finite())
            }
            _ => true,
        };
        prop_assert!(finite, "`{name}` is not finite in {format}");
    }
    prop_assert!(gpu().check().is_ok(), "{:?}", gpu().check());
    Ok(())
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn anything_renders(scene in scene(), format in 0..3usize) {
        let formats = Formats::builtin();
        let format = formats.iter().nth(format % formats.iter().count()).unwrap().name();
        check(&scene, format, "final")?;
    }
}

proptest! {
    #![proptest_config(config(24))]

    /// In a grid of voxels of size 1, so that the epsilon is one of voxels; triangles from specks to the whole grid.
    #[test]
    fn occupancy_is_that_of_the_exact_model(
        list in prop::collection::vec((point(0.0..29.0f64), triangle(-1.0..1.0f64), -3.0..1.3f64), 1..40),
        turn in point(-3.2..3.2f64),
        thin in any::<bool>(),
    ) {
        let list: Vec<[Vec3; 3]> = list
            .into_iter()
            .map(|(middle, corners, size)| {
                let around = |corner: Vec3| {
                    (middle + corner.as_dvec3() * 10f64.powf(size)).clamp(DVec3::ZERO, DVec3::splat(29.0)).as_vec3()
                };
                corners.map(around)
            })
            // The exact model calls a triangle without area a segment, which the device leaves out.
            .filter(|[a, b, c]| (*b - *a).cross(*c - *a).length() > 1e-3 * (*b - *a).length() * (*c - *a).length())
            .collect();
        let mut scene = scene_of(vec![triangles(&list), span(29.0)], 29.0);
        // About the middle, in steps of right angles, so that it stays in the grid.
        let quarter = |angle: f64| (angle / std::f64::consts::FRAC_PI_2).round() * std::f64::consts::FRAC_PI_2;
        let rotation = DAffine3::from_quat(DQuat::from_euler(EulerRot::XYZ, quarter(turn.x), quarter(turn.y), quarter(turn.z)));
        let middle = DAffine3::from_translation(DVec3::splat(14.5));
        scene.instances[0].transform = middle * rotation * middle.inverse();
        let separability = if thin { Separability::Thin } else { Separability::Conservative };
        let text = std::fs::read_to_string(voxlume_tests::root().join("pipelines/gi.ron")).unwrap();
        let text = if thin { text.replace("\"conservative\"", "\"thin\"") } else { text };
        let pipeline = voxlume::Pipeline::parse(&voxlume::Source::new("gi.ron", text)).unwrap();
        let request = Request { resolution: Some(32), output: Some("diffuse".into()), ..Request::image(8, 8) };
        let substrate = Substrate::read(&voxlume_tests::render(&pipeline, &scene, &request));
        let compared = compare(&substrate, &substrate.triangles(&scene), separability, EPSILON);
        prop_assert!(compared.missing.is_empty(), "{} missing, such as {}", compared.missing.len(), compared.missing[0]);
        prop_assert!(compared.extra.is_empty(), "{} set in vain, such as {}", compared.extra.len(), compared.extra[0]);
    }
}
