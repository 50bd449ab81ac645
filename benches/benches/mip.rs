//! What active-voxel lists spare when levels are made (RAU §5.4): one chain of levels over Sponza's occupied voxels
//! against one over all cells, on one device in one run: `cargo bench -p voxlume-benches --bench mip`.
//!
//! `-- N` takes another resolution than 128.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;

use voxlume::{
    Formats, Gpu, Passes, Pipeline, Plan, Registry, Renderer, Request, Scene, SceneFacts, Value, plan,
};
use voxlume_benches::{enter_repository, shared_scene};

const FRAMES: usize = 7;

fn main() {
    enter_repository().expect("the repository");
    let path = shared_scene("sponza");
    if !path.exists() {
        println!("skipped: there is no {}", path.display());
        return;
    }
    let resolution = std::env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(128);
    let scene = Scene::load(&path).expect("the sample scene");
    let pipeline = Pipeline::load(Path::new("pipelines/gi.ron")).expect("the default pipeline");
    let gpu = Gpu::open(None).expect("a device");
    println!("{}, {resolution}³, medians of {FRAMES} frames after one of warm-up, ms", gpu.info.name);
    println!("format     active voxels  all cells  ratio");
    for format in Formats::builtin().iter() {
        let time = |cells: &str| {
            let request = Request {
                format: Some(format.name().to_owned()),
                resolution: Some(resolution),
                output: Some("diffuse".into()),
                set: vec![("filter".into(), "cells".into(), Value::Word(cells.into()))],
                ..Request::image(8, 8)
            };
            let facts = SceneFacts::of(&scene).expect("checked as it was loaded");
            let plan = plan(&pipeline, &facts, &Registry::builtin(), &request);
            median(&gpu, split(plan.expect("a plan")), &scene)
        };
        let (active, all) = (time("active"), time("all"));
        println!("{:<10} {active:>13.2}  {all:>9.2}  {:>5.1}", format.name(), all / active);
    }
}

/// Makes the levels a pass of their own, so that they are timed without the store.
fn split(mut plan: Plan) -> Plan {
    let levels = plan.grid.levels() as usize - 1;
    let at = plan.passes.iter().position(|pass| pass.name == "filter").expect("the filter");
    let mut mips = plan.passes[at].clone();
    mips.name = "levels".into();
    let stored = mips.steps.len() - levels;
    mips.steps.drain(..stored);
    plan.passes[at].steps.truncate(stored);
    plan.passes.insert(at + 1, mips);
    plan
}

fn median(gpu: &Gpu, plan: Plan, scene: &Scene) -> f64 {
    let mut renderer = Renderer::new(gpu, plan, scene).expect("a renderer");
    let mut times: Vec<f64> = (0..=FRAMES)
        .map(|_| {
            let times = renderer.render(scene, &scene.cameras[0], Passes::All).expect("a frame");
            times.iter().filter(|time| time.name == "levels").map(|time| time.milliseconds).sum()
        })
        .skip(1)
        .collect();
    times.sort_by(f64::total_cmp);
    times[FRAMES / 2]
}
