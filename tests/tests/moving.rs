//! Scenes that move: what is redone, and that it comes to the same bits as doing everything anew.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{DQuat, DVec3, Vec3};
use voxlume::scene::{Key, Light, LightKind, Material, Mesh, Moved, Path};
use voxlume::{Passes, Renderer, Request, Scene, Value};
use voxlume_tests::{
    Random, Substrate, add, built_in, gi, gpu, picture, plan_for, render, scene_of, soup, span, triangles,
};

fn request(format: &str) -> Request {
    // Cones, which a format has a part in.
    let tracer = Some("cones".into());
    Request { format: Some(format.into()), tracer, resolution: Some(32), ..Request::image(24, 24) }
}

/// The scene as it stands, as if nothing of it moved.
fn anew(scene: &Scene, request: &Request) -> Renderer<'static> {
    let mut still = scene.clone();
    still.instances.iter_mut().for_each(|instance| instance.moving = false);
    render(&gi(), &still, request)
}

fn at(renderer: &mut Renderer<'_>, scene: &mut Scene, time: f64) -> Vec<String> {
    scene.set_time(time);
    renderer.update(scene).unwrap();
    let times = renderer.render(scene, &scene.cameras[0], Passes::Changed).unwrap();
    times.into_iter().map(|time| time.name).collect()
}

/// Substrate and image of some frames, against both made anew.
fn is_as_anew(scene: &mut Scene, request: &Request, times: &[f64]) {
    scene.set_time(times[0]);
    let mut renderer = Renderer::new(gpu(), plan_for(&gi(), scene, request), scene).unwrap();
    let mut seen = Vec::new();
    for (frame, time) in times.iter().enumerate() {
        let passes = at(&mut renderer, scene, *time);
        assert!(passes.contains(&"voxelize".to_owned()), "{passes:?}");
        let fresh = anew(scene, request);
        let (moved, expected) = (Substrate::read(&renderer), Substrate::read(&fresh));
        assert!(moved.levels[0].count > 500);
        assert!(moved.occupancy == expected.occupancy, "occupancy at {time}");
        assert!(moved.attributes == expected.attributes, "attributes at {time}");
        assert!(moved == expected, "substrate at {time}");
        assert!(picture(&renderer, "final") == picture(&fresh, "final"), "image at {time}");
        // Once the first frame is done, what never moves is not voxelized again.
        assert!(frame == 0 || !passes.contains(&"voxelize static".to_owned()), "{passes:?}");
        assert!(!seen.contains(&moved.attributes), "nothing has moved until {time}");
        seen.push(moved.attributes);
    }
}

#[test]
fn frames_have_the_bits_of_voxelizing_anew() {
    for format in ["isotropic", "six_face", "sh2"] {
        is_as_anew(&mut built_in("moving.ron"), &request(format), &[0.0, 0.3, 1.55, 0.9]);
    }
}

#[test]
fn every_method_of_voxelization_takes_a_part_of_the_triangles() {
    let mut scene = built_in("moving.ron");
    for method in ["triangle", "fragment", "hybrid"] {
        let set = vec![("voxelize".into(), "method".into(), Value::Word(method.into()))];
        is_as_anew(&mut scene, &Request { set, ..request("isotropic") }, &[0.1, 0.7]);
    }
}

fn key(time: f64, scale: f64, angle: f64, translation: DVec3) -> Key {
    Key { time, scale: DVec3::splat(scale), rotation: DQuat::from_rotation_y(angle), translation }
}

/// Lets an instance follow a path about the middle of a cube of side `side`.
fn moves(scene: &mut Scene, index: usize, side: f64, keys: Vec<Key>) {
    let middle = DVec3::splat(side / 2.0);
    let instance = &mut scene.instances[index];
    instance.moving = true;
    let rest = glam::DAffine3::from_translation(-middle) * instance.transform;
    let keys = keys.into_iter().map(|key| Key { translation: key.translation + middle, ..key }).collect();
    scene.animation.instances.push(Moved { index, rest, path: Path { keys } });
}

/// A box with so many random triangles that stay and so many that may move: each a mesh without and one with a mask.
fn soups(still: usize, moving: usize) -> Scene {
    let mut scene = scene_of(vec![span(29.0)], 29.0);
    let mask = Material { name: "masked".into(), alpha_cutoff: Some(0.5), ..Material::default() };
    scene.materials.push(mask);
    for (seed, count) in [(1, still), (2, moving)].into_iter().filter(|(_, count)| *count > 0) {
        for material in 0..2 {
            let mesh = triangles(&soup(2 * seed + material, count / 2, 29.0, (2.0, 12.0)));
            add(&mut scene, Mesh { material: material as usize, ..mesh });
        }
    }
    scene
}

#[test]
fn random_triangles_and_memory_that_grows() {
    let mut scene = soups(6, 90);
    // From a speck to all of the grid: more voxels than in the first frame by far.
    let keys = vec![key(0.0, 0.01, 0.0, DVec3::ZERO), key(1.0, 0.9, 1.5, DVec3::new(1.0, 0.0, -1.0))];
    moves(&mut scene, 3, 29.0, keys.clone());
    moves(&mut scene, 4, 29.0, keys);
    scene.set_time(0.0);
    let few = Substrate::read(&anew(&scene, &request("isotropic"))).levels[0].count;
    scene.set_time(1.0);
    assert!(Substrate::read(&anew(&scene, &request("isotropic"))).levels[0].count > 2 * few + 256);
    let mut random = Random::new(3);
    let times: Vec<f64> = std::iter::once(0.0).chain((0..3).map(|_| random.between(0.5, 1.0))).collect();
    // A frame that outgrows its memory is done over, what never moves included.
    let mut renderer = Renderer::new(gpu(), plan_for(&gi(), &scene, &request("isotropic")), &scene).unwrap();
    for time in times {
        at(&mut renderer, &mut scene, time);
        let fresh = anew(&scene, &request("isotropic"));
        assert!(Substrate::read(&renderer) == Substrate::read(&fresh), "substrate at {time}");
        assert!(picture(&renderer, "final") == picture(&fresh, "final"), "image at {time}");
    }
}

#[test]
fn a_scene_all_of_which_moves() {
    let mut scene = soups(0, 60);
    for index in 0..3 {
        moves(&mut scene, index, 29.0, vec![key(0.0, 0.8, 0.0, DVec3::ZERO), key(1.0, 0.8, 2.0, DVec3::ONE)]);
    }
    is_as_anew(&mut scene, &request("isotropic"), &[0.0, 0.5, 1.0]);
}

#[test]
fn a_light_that_moves_leaves_the_voxels_alone() {
    let mut scene = soups(60, 0);
    let kind = LightKind::Point { position: DVec3::new(14.0, 28.0, 40.0), radius: 0.0 };
    scene.lights.push(Light { name: "lamp".into(), kind, intensity: Vec3::splat(2000.0) });
    let keys = vec![key(0.0, 1.0, 0.0, DVec3::ZERO), key(1.0, 1.0, 0.0, DVec3::new(10.0, 0.0, 0.0))];
    scene.animation.lights.push(Moved { index: 0, rest: kind, path: Path { keys } });
    let plan = plan_for(&gi(), &scene, &request("isotropic"));
    assert!(plan.resource("static_occupancy").is_none() && plan.resource("occupancy_before").is_none());
    let mut renderer = Renderer::new(gpu(), plan, &scene).unwrap();
    at(&mut renderer, &mut scene, 0.0);
    let (voxels, image) = (Substrate::read(&renderer), picture(&renderer, "final"));
    let passes = at(&mut renderer, &mut scene, 1.0);
    assert!(passes.contains(&"light".to_owned()) && !passes.iter().any(|pass| pass.contains("voxelize")));
    assert!(Substrate::read(&renderer) == voxels);
    assert!(picture(&renderer, "final") != image, "the light has not moved");
    assert!(picture(&renderer, "final") == picture(&anew(&scene, &request("isotropic")), "final"));
}

#[test]
fn another_scene_is_no_update() {
    let mut scene = soups(20, 20);
    moves(&mut scene, 4, 29.0, vec![key(0.0, 0.5, 0.0, DVec3::ZERO)]);
    let mut renderer = Renderer::new(gpu(), plan_for(&gi(), &scene, &request("isotropic")), &scene).unwrap();
    scene.meshes.last_mut().unwrap().triangles.pop();
    let error = renderer.update(&scene).unwrap_err();
    assert_eq!(
        error.to_string(),
        "this is another scene than the one that was planned for: it has 41 triangles instead of 42"
    );
}
