//! Hard cases: scale, distance, thinness, degenerate triangles.

use glam::{DAffine3, DVec3, Vec3};
use voxlume_reference::{Gather, Quantity};
use voxlume_scene::{Camera, LightKind, Material, Mesh, Scene};

use crate::stage::*;

/// A room with a lamp, an emitter and a pillar, scaled and moved.
fn room_at(scale: f64, offset: DVec3) -> (Scene, Camera) {
    let mut scene = Scene::default();
    add_quads(&mut scene, grey(0.7), &room(Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, 2.0, 1.0)));
    let pillar: Vec<_> = room(Vec3::new(-0.5, 0.0, -0.5), Vec3::new(0.0, 1.0, 0.0))
        .into_iter()
        .map(|[a, b, c, d]| [a, d, c, b])
        .collect();
    add_quads(&mut scene, grey(0.7), &pillar);
    add_disc(&mut scene, emissive(5.0), Vec3::new(0.4, 1.9, 0.4), 0.3, false);
    for instance in &mut scene.instances {
        instance.transform = DAffine3::from_translation(offset) * DAffine3::from_scale(DVec3::splat(scale));
    }
    let position = DVec3::new(0.6, 1.5, -0.6) * scale + offset;
    let kind = LightKind::Point { position, radius: (0.1 * scale) as f32 };
    add_light(&mut scene, kind, (scale * scale) as f32);
    let eye = DVec3::new(0.8, 0.9, 0.85);
    let target = DVec3::new(0.0, 0.3, -0.1);
    let forward = (target - eye).normalize().as_vec3();
    let up = forward.cross(Vec3::Y).cross(forward).normalize();
    let camera = Camera { name: "c".into(), eye: eye * scale + offset, forward, up, vertical_fov: 1.0 };
    (scene, camera)
}

#[test]
fn scale_and_place_change_nothing() {
    let quantities = |scale: f32| {
        [
            Quantity::Final { bounces: 2 },
            Quantity::Diffuse(Gather { bounces: 1, sky: true, emission: false }),
            Quantity::AmbientOcclusion { distance: scale, falloff: 1.0 / scale },
            Quantity::SoftShadow { light: 0 },
        ]
    };
    let measured = |scale: f64, offset: f64| {
        let (scene, camera) = room_at(scale, DVec3::splat(offset));
        quantities(scale as f32).map(|quantity| measure(&scene, &request(camera.clone(), quantity, 64)))
    };
    let plain = measured(1.0, 0.0);
    for (scale, offset) in [(1e-4, 0.0), (1e4, 0.0), (1.0, 1e6), (3.7, -1e5)] {
        for (there, here) in measured(scale, offset).iter().zip(&plain) {
            // The same random numbers: only rounding may send a path elsewhere.
            let tolerance = 0.5 * here.1 + 1e-4 * here.0;
            assert!((there.0 - here.0).abs() < tolerance, "{scale} {offset}: {there:?} {here:?}");
        }
    }
}

#[test]
fn no_light_leaks_into_a_closed_room_with_thin_walls() {
    let mut scene = Scene::default();
    let (low, high) = (Vec3::new(-1.0, 0.0, -1.3), Vec3::new(1.0, 2.0, 1.7));
    add_quads(&mut scene, Material { double_sided: true, ..grey(0.9) }, &room(low, high));
    scene.sky = Vec3::splat(100.0);
    let direction = Vec3::new(0.3, -1.0, 0.2).normalize();
    add_light(&mut scene, LightKind::Directional { direction, angular_diameter: 0.2 }, 1000.0);
    add_light(&mut scene, LightKind::Point { position: dvec3(1.1, 1.0, 0.0), radius: 0.05 }, 1000.0);
    let camera = Camera { vertical_fov: 2.8, ..look(Vec3::new(0.1, 1.0, 0.2), Vec3::new(1.0, 0.0, 1.0)) };
    let request = request(camera, Quantity::Final { bounces: 4 }, 100);
    assert_eq!(measure(&scene, &request), (0.0, 0.0));
}

#[test]
fn scenes_without_triangles_and_triangles_without_area() {
    let sky = Scene { sky: Vec3::ONE, ..Scene::default() };
    let camera = look(Vec3::new(0.0, 1.0, 0.2), Vec3::ZERO);
    let picture = request(camera.clone(), Quantity::Final { bounces: 1 }, 20);
    assert_eq!(measure(&sky, &picture), (1.0, 0.0));

    let plain = Scene { sky: Vec3::ONE, ..floor(grey(0.5)) };
    let mut slivers = plain.clone();
    let mut mesh = Mesh { material: 1, ..Mesh::default() };
    for i in 0..300u32 {
        let p = Vec3::new((i as f32).sin(), 0.1, (i as f32).cos());
        // Points, lines, and slivers a millionth wide.
        let q = if i % 3 == 0 { p } else { p * 40.0 };
        mesh.positions.extend([p, q, if i % 3 == 2 { p + Vec3::Y * 1e-6 } else { p }]);
        mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    let count = mesh.positions.len();
    mesh.normals = vec![Vec3::Y; count];
    mesh.tangents = vec![Vec3::X.extend(1.0); count];
    mesh.uvs = vec![glam::Vec2::ZERO; count];
    slivers.materials.push(emissive(1.0));
    add_mesh(&mut slivers, mesh);
    let ((with, error), (without, _)) = (measure(&slivers, &picture), measure(&plain, &picture));
    assert!((with - without).abs() < 4.0 * error + 1e-3, "{with} {without} {error}");
}

#[test]
fn radiance_from_dim_to_bright_is_kept() {
    for radiance in [1e-6f32, 1.0, 1e5] {
        let mut scene = floor(grey(0.5));
        scene.sky = Vec3::splat(radiance);
        let camera = look(Vec3::new(0.0, 1.0, 0.5), Vec3::ZERO);
        let request = lambert(camera, Quantity::Final { bounces: 3 }, 4);
        expect(&scene, &request, 0.5 * f64::from(radiance));
    }
}

/// A mirrored instance keeps its front and its normal map's handedness.
#[test]
fn mirrored_instances() {
    let mut scene = floor(grey(0.5));
    scene.sky = Vec3::ONE;
    scene.instances[0].transform = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 2.0));
    let camera = look(Vec3::new(0.0, 1.0, 0.5), Vec3::ZERO);
    expect(&scene, &lambert(camera, Quantity::Final { bounces: 0 }, 4), 0.5);
}
