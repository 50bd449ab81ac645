//! Same bits, honest errors, clean stops.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use glam::Vec3;
use voxlume_reference::{Error, PixelSampling, Quantity, Request, Tracer};
use voxlume_scene::{Camera, LightKind, Material, Scene};

use crate::stage::*;

/// A glossy furnace: noisy, with a known answer for its Lambert part.
fn scene() -> Scene {
    let mut scene = Scene::default();
    let material = Material { emission: Vec3::new(1.0, 0.5, 0.2), roughness: 0.4, ..grey(0.7) };
    add_quads(&mut scene, material, &room(Vec3::new(-1.0, 0.0, -2.0), Vec3::new(1.5, 2.0, 2.0)));
    add_light(&mut scene, LightKind::Point { position: dvec3(0.2, 1.5, 0.3), radius: 0.2 }, 1.0);
    scene
}

fn wide(quantity: Quantity, samples: u32) -> Request {
    let camera = Camera { vertical_fov: 1.2, ..look(Vec3::new(0.0, 1.0, 0.0), Vec3::new(1.5, 0.7, 0.4)) };
    Request { sampling: PixelSampling::Area, width: 21, height: 13, ..request(camera, quantity, samples) }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let tracer = Tracer::new(&scene()).unwrap();
    let request = wide(Quantity::Final { bounces: 3 }, 16);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| tracer.render(&request, &|_| (), &AtomicBool::new(false))).unwrap()
    };
    let one = with(1);
    assert_eq!(one, with(4));
    assert_eq!((one.width, one.height, one.mean.len(), one.standard_error.len()), (21, 13, 273, 273));
}

#[test]
fn another_seed_gives_other_noise_around_the_same_mean() {
    let request = wide(Quantity::Final { bounces: 3 }, 16);
    let (a, error) = measure(&scene(), &request);
    let (b, _) = measure(&scene(), &Request { seed: 2, ..request });
    assert_ne!(a, b);
    assert!((a - b).abs() < 4.0 * error, "{a} {b} {error}");
}

#[test]
fn four_times_the_samples_halve_the_error() {
    let error = |samples| measure(&scene(), &wide(Quantity::Final { bounces: 2 }, samples)).1;
    let ratio = error(64) / error(256);
    assert!((ratio - 2.0).abs() < 0.1, "{ratio}");
}

/// How often the truth lies within one and two standard errors of a pixel: 68 % and 95 % by the
/// normal distribution.
#[test]
fn standard_errors_cover_the_truth() {
    let mut scene = floor(grey(1.0));
    add_disc(&mut scene, emissive(1.0), Vec3::Y, 1.0, false);
    add_disc(&mut scene, emissive(2.0), Vec3::Y * 0.6, 0.3, false);
    // 1·(½ − ⅕) seen around the near disc, which subtends sin²θ = ⅕.
    let truth = 0.3 + 2.0 * 0.2;
    let camera = look(Vec3::new(0.5, 0.4, 0.2), Vec3::ZERO);
    let request = Request { width: 40, height: 40, ..lambert(camera, Quantity::Final { bounces: 0 }, 100) };
    let picture = render(&scene, &request);
    let within = |k: f64| {
        let covered = picture
            .mean
            .iter()
            .zip(&picture.standard_error)
            .filter(|(mean, error)| (f64::from(mean[0]) - truth).abs() <= k * f64::from(error[0]));
        covered.count() as f64 / picture.mean.len() as f64
    };
    assert!((within(1.0) - 0.683).abs() < 0.04, "{}", within(1.0));
    assert!((within(2.0) - 0.954).abs() < 0.02, "{}", within(2.0));
}

#[test]
fn progress_rises_to_one() {
    let told = Mutex::new(Vec::new());
    let tracer = Tracer::new(&scene()).unwrap();
    let request = wide(Quantity::Final { bounces: 0 }, 2);
    tracer.render(&request, &|done| told.lock().unwrap().push(done), &AtomicBool::new(false)).unwrap();
    let told = told.into_inner().unwrap();
    assert_eq!(told.len(), 13);
    assert!(told.is_sorted());
    assert_eq!(told.last(), Some(&1.0));
}

#[test]
fn the_cancel_flag_stops_the_work() {
    let tracer = Tracer::new(&scene()).unwrap();
    let cancel = AtomicBool::new(false);
    // Hours of work, stopped when the first of many rows is done.
    let request = Request { height: 100_000, ..wide(Quantity::Final { bounces: 3 }, 64) };
    let result = tracer.render(&request, &|_| cancel.store(true, Ordering::Relaxed), &cancel);
    assert_eq!(result, Err(Error::Cancelled));
}
