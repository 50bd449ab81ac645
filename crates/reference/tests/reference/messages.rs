//! Every fault of a request, word by word.

use std::sync::atomic::AtomicBool;

use glam::Vec3;
use voxlume_reference::{Quantity, Request, Tracer};
use voxlume_scene::LightKind;

use crate::stage::*;

fn message(change: impl FnOnce(&mut Request)) -> String {
    let mut scene = floor(grey(0.5));
    add_light(&mut scene, LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter: 0.0 }, 1.0);
    add_light(&mut scene, LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter: 0.0 }, 1.0);
    let mut request = request(look(Vec3::Y, Vec3::ZERO), Quantity::Final { bounces: 0 }, 2);
    change(&mut request);
    let tracer = Tracer::new(&scene).unwrap();
    tracer.render(&request, &|_| (), &AtomicBool::new(false)).unwrap_err().to_string()
}

#[test]
fn sizes_and_samples() {
    assert_eq!(
        message(|request| request.width = 0),
        "picture of 0x16 pixels: each side must be at least 1, with at most 67108864 pixels in all"
    );
    assert_eq!(
        message(|request| (request.width, request.height) = (u32::MAX, u32::MAX)),
        "picture of 4294967295x4294967295 pixels: each side must be at least 1, with at most 67108864 pixels in all"
    );
    assert_eq!(
        message(|request| request.samples = 1),
        "1 samples a pixel: at least 2 are needed to tell the standard error"
    );
}

#[test]
fn cameras() {
    assert_eq!(message(|request| request.camera.eye.x = f64::NAN), "camera `c`: eye must be finite");
    assert_eq!(
        message(|request| request.camera.up = request.camera.forward),
        "camera `c`: forward and up must be of unit length and at right angles"
    );
    assert_eq!(
        message(|request| request.camera.vertical_fov = 4.0),
        "camera `c`: vertical_fov must be above 0 and below π"
    );
}

#[test]
fn quantities() {
    assert_eq!(
        message(|request| request.quantity = Quantity::SoftShadow { light: 2 }),
        "no light 2: the scene has 0 `light 0`, 1 `light 1`"
    );
    let occlusion = |distance, falloff| {
        message(|request| request.quantity = Quantity::AmbientOcclusion { distance, falloff })
    };
    let rule = "the distance must be above 0 (infinity is allowed) and the falloff finite and at least 0";
    assert_eq!(occlusion(0.0, 1.0), format!("ambient occlusion to distance 0 with falloff 1: {rule}"));
    assert_eq!(
        occlusion(1.0, f32::INFINITY),
        format!("ambient occlusion to distance 1 with falloff inf: {rule}")
    );
}

#[test]
fn radiance_beyond_floats() {
    let mut scene = floor(grey(0.5));
    scene.sky = Vec3::splat(f32::MAX);
    let gather = voxlume_reference::Gather { bounces: 0, sky: true, emission: false };
    let request = request(look(Vec3::Y, Vec3::ZERO), Quantity::Diffuse(gather), 2);
    let tracer = Tracer::new(&scene).unwrap();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let error = pool.install(|| tracer.render(&request, &|_| (), &AtomicBool::new(false))).unwrap_err();
    assert_eq!(
        error.to_string(),
        "pixel (0, 0) is not finite: a light, an emission or the sky is too bright for 32-bit floats"
    );
}

#[test]
fn a_scene_without_lights() {
    let request = request(look(Vec3::Y, Vec3::ZERO), Quantity::SoftShadow { light: 0 }, 2);
    let tracer = Tracer::new(&floor(grey(0.5))).unwrap();
    let error = tracer.render(&request, &|_| (), &AtomicBool::new(false)).unwrap_err();
    assert_eq!(error.to_string(), "no light 0: the scene has no lights");
}
