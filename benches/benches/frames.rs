//! What a frame costs by what has changed since the one before, on one device in one run:
//! `cargo bench -p voxlume-benches --bench frames`.
//!
//! `-- N` takes another resolution than 128.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;

use glam::Vec3;
use voxlume::scene::{Light, LightKind};
use voxlume::{Frame, Gpu, PassTime, Passes, Pipeline, Registry, Renderer, Request, Scene, SceneFacts, plan};

const FRAMES: usize = 5;
const SIZE: [u32; 2] = [320, 180];

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let resolution = std::env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(128);
    let gpu = Gpu::open(None).expect("a device");
    println!(
        "{}, {resolution}³, {} × {} pixels, medians of {FRAMES} frames after one of warm-up, ms\n",
        gpu.info.name, SIZE[0], SIZE[1]
    );
    println!(
        "| scene | all passes | all but voxelization | a lamp moves | the camera moves | nothing moves |"
    );
    println!("|---|---|---|---|---|---|");
    for path in ["scenes/cornell.ron", "../shared/scenes/sponza_lite.glb"] {
        let path = root.join(path);
        if path.exists() {
            row(&gpu, Scene::load(&path).expect("a scene"), resolution);
        } else {
            println!("skipped: there is no {}", path.display());
        }
    }
}

fn row(gpu: &Gpu, mut scene: Scene, resolution: u32) {
    // A lamp that every scene has.
    let kind = LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter: 0.01 };
    scene.lights.push(Light { name: "lamp".into(), kind, intensity: Vec3::ONE });
    let facts = SceneFacts::of(&scene).expect("checked as it was loaded");
    let pipeline = Pipeline::builtin("gi").expect("a built-in pipeline");
    let request = Request { resolution: Some(resolution), ..Request::image(SIZE[0], SIZE[1]) };
    let plan = plan(&pipeline, &facts, &Registry::builtin(), &request).expect("a plan");
    let mut renderer = Renderer::new(gpu, plan, &scene).expect("a renderer");
    let mut camera = scene.cameras[0].clone();
    let all = median(|| {
        let frame = Frame { passes: Passes::All, ..Frame::of(&camera) };
        let times = renderer.frame(&frame).expect("a frame");
        [sum(&times, |_| true), sum(&times, |name| name != "voxelize")]
    });
    let lamp = median(|| {
        scene.lights.last_mut().unwrap().intensity *= 1.01;
        renderer.update(&scene).expect("the same scene");
        [sum(&renderer.frame(&Frame::of(&camera)).expect("a frame"), |_| true)]
    });
    let moved = median(|| {
        camera.eye.x += 1e-3;
        [sum(&renderer.frame(&Frame::of(&camera)).expect("a frame"), |_| true)]
    });
    let still = median(|| [sum(&renderer.frame(&Frame::of(&camera)).expect("a frame"), |_| true)]);
    println!(
        "| {} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} |",
        scene.name, all[0], all[1], lamp[0], moved[0], still[0]
    );
}

fn sum(times: &[PassTime], counts: impl Fn(&str) -> bool) -> f64 {
    times.iter().filter(|time| counts(&time.name)).fold(0.0, |sum, time| sum + time.milliseconds)
}

fn median<const N: usize>(mut frame: impl FnMut() -> [f64; N]) -> [f64; N] {
    let frames: Vec<[f64; N]> = (0..=FRAMES).map(|_| frame()).skip(1).collect();
    std::array::from_fn(|column| {
        let mut times: Vec<f64> = frames.iter().map(|frame| frame[column]).collect();
        times.sort_by(f64::total_cmp);
        times[FRAMES / 2]
    })
}
