//! Pictures on disk: kept, found, and never trusted when damaged.

use std::fs;

use glam::{DAffine3, DVec3, Vec3};
use voxlume_reference::cache::{Cache, Key, SceneDigest};
use voxlume_reference::{Error, Gather, Picture, PixelSampling, Quantity, Reflection, Request};
use voxlume_scene::{LightKind, Scene};

use crate::stage::*;

fn picture() -> Picture {
    let pixel = |i: u32| [i as f32, -0.5, 1e-30];
    Picture {
        width: 3,
        height: 2,
        mean: (0..6).map(pixel).collect(),
        standard_error: (6..12).map(pixel).collect(),
    }
}

fn some_request() -> Request {
    request(look(Vec3::Y, Vec3::ZERO), Quantity::Final { bounces: 1 }, 4)
}

fn some_scene() -> Scene {
    let mut scene = floor(grey(0.5));
    add_texture(&mut scene, 1, true, &[[1, 2, 3, 4]]);
    add_light(&mut scene, LightKind::Point { position: dvec3(0.0, 1.0, 0.0), radius: 0.1 }, 1.0);
    scene
}

fn some_key() -> Key {
    Key::new(&SceneDigest::of(&some_scene()), &some_request())
}

#[test]
fn a_stored_picture_comes_back_bit_by_bit() {
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::new(folder.path().join("made on demand"));
    let key = some_key();
    assert_eq!(cache.load(&key, 3, 2), None);
    let first = cache.get_or_compute(&key, 3, 2, || Ok(picture())).unwrap();
    assert!(!first.hit && first.store_error.is_none());
    let second = cache.get_or_compute(&key, 3, 2, || panic!("computed again")).unwrap();
    assert!(second.hit);
    assert_eq!((first.picture, second.picture), (picture(), picture()));
    // One file, no temporaries left.
    assert_eq!(fs::read_dir(folder.path().join("made on demand")).unwrap().count(), 1);
}

#[test]
fn a_damaged_entry_is_computed_again_and_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::new(folder.path());
    let key = some_key();
    cache.store(&key, &picture()).unwrap();
    let path = cache.path(&key);
    let good = fs::read(&path).unwrap();
    let mut damages: Vec<Vec<u8>> = (0..good.len())
        .map(|at| {
            let mut bytes = good.clone();
            bytes[at] ^= 0x10;
            bytes
        })
        .collect();
    damages.extend([Vec::new(), good[..good.len() - 1].to_vec(), [&good[..], &[0]].concat()]);
    for bytes in damages {
        fs::write(&path, bytes).unwrap();
        assert_eq!(cache.load(&key, 3, 2), None);
    }
    assert!(!cache.get_or_compute(&key, 3, 2, || Ok(picture())).unwrap().hit);
    assert_eq!(fs::read(&path).unwrap(), good);
    // Intact, but another picture's.
    let other = Key::new(&SceneDigest::of(&some_scene()), &Request { seed: 9, ..some_request() });
    fs::copy(&path, cache.path(&other)).unwrap();
    assert_eq!(cache.load(&other, 3, 2), None);
    assert_eq!(cache.load(&key, 2, 3), None);
}

#[test]
fn a_folder_that_cannot_be_written_costs_only_the_keeping() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let cached = Cache::new(file.path()).get_or_compute(&some_key(), 3, 2, || Ok(picture())).unwrap();
    assert_eq!(cached.picture, picture());
    assert!(cached.store_error.is_some());
}

#[test]
fn failures_are_passed_on_and_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::new(folder.path());
    let failed = cache.get_or_compute(&some_key(), 3, 2, || Err(Error::Cancelled));
    assert_eq!(failed.unwrap_err(), Error::Cancelled);
    assert_eq!(cache.load(&some_key(), 3, 2), None);
}

#[test]
fn whatever_decides_the_picture_decides_the_key() {
    let scene_changes: [fn(&mut Scene); 22] = [
        |s| s.sky.x = 1.0,
        |s| s.materials[0].base_color.y = 0.1,
        |s| s.materials[0].base_color_texture = Some(voxlume_scene::TextureRef { texture: 0 }),
        |s| s.materials[0].emission_texture = Some(voxlume_scene::TextureRef { texture: 0 }),
        |s| s.materials[0].normal_texture = Some(voxlume_scene::TextureRef { texture: 0 }),
        |s| s.materials[0].metallic_roughness_texture = Some(voxlume_scene::TextureRef { texture: 0 }),
        |s| s.materials[0].metallic = 0.5,
        |s| s.materials[0].roughness = 0.5,
        |s| s.materials[0].normal_scale = 0.5,
        |s| s.materials[0].emission.z = 0.5,
        |s| s.materials[0].alpha_cutoff = Some(0.0),
        |s| s.materials[0].double_sided = true,
        |s| s.textures[0].rgba[2] = 7,
        |s| s.textures[0].srgb = false,
        |s| s.meshes[0].positions[0].x = 7.0,
        |s| s.meshes[0].normals[0].x = 7.0,
        |s| s.meshes[0].tangents[0].w = -1.0,
        |s| s.meshes[0].uvs[0].x = 7.0,
        |s| s.meshes[0].triangles[0].swap(0, 1),
        |s| s.instances[0].transform = DAffine3::from_translation(DVec3::X),
        |s| s.lights[0].intensity.x = 7.0,
        |s| s.lights[0].kind = LightKind::Point { position: dvec3(0.0, 1.0, 0.0), radius: 0.2 },
    ];
    let gather = Gather { bounces: 1, sky: true, emission: true };
    let request_changes: [fn(&mut Request); 14] = [
        |r| r.camera.eye.x = 1.0,
        |r| r.camera.forward = Vec3::X,
        |r| r.camera.up = -r.camera.up,
        |r| r.camera.vertical_fov = 1.0,
        |r| r.width = 8,
        |r| r.height = 8,
        |r| r.samples = 8,
        |r| r.seed = 8,
        |r| r.sampling = PixelSampling::Area,
        |r| r.reflection = Reflection::Lambert,
        |r| r.quantity = Quantity::Final { bounces: 2 },
        |r| r.quantity = Quantity::SoftShadow { light: 0 },
        |r| r.quantity = Quantity::AmbientOcclusion { distance: 1.0, falloff: 1.0 },
        |r| r.quantity = Quantity::AmbientOcclusion { distance: 1.0, falloff: 2.0 },
    ];
    let mut keys = vec![some_key()];
    for change in scene_changes {
        let mut scene = some_scene();
        change(&mut scene);
        keys.push(Key::new(&SceneDigest::of(&scene), &some_request()));
    }
    let mut add = |request: &Request| keys.push(Key::new(&SceneDigest::of(&some_scene()), request));
    for change in request_changes {
        let mut request = some_request();
        change(&mut request);
        add(&request);
    }
    for gather in [
        gather,
        Gather { bounces: 2, ..gather },
        Gather { sky: false, ..gather },
        Gather { emission: false, ..gather },
    ] {
        add(&Request { quantity: Quantity::Diffuse(gather), ..some_request() });
        add(&Request { quantity: Quantity::Specular(gather), ..some_request() });
    }
    let count = keys.len();
    keys.sort_by_key(Key::to_hex);
    keys.dedup();
    assert_eq!(keys.len(), count);
}

#[test]
fn names_cameras_and_movement_do_not() {
    let mut scene = some_scene();
    scene.name = "other".into();
    scene.materials[0].name = "other".into();
    scene.lights[0].name = "other".into();
    scene.cameras.push(some_request().camera);
    scene.instances[0].moving = true;
    assert_eq!(SceneDigest::of(&scene), SceneDigest::of(&some_scene()));
}
