//! Plans and frames on the one device of a test program.
#![allow(clippy::panic)]

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use voxlume::{Gpu, Passes, Picture, Pipeline, Plan, Registry, Renderer, Request, Scene, SceneFacts, Value};

/// The repository's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The device that all tests of a program share.
///
/// # Panics
/// No device can be opened: a test that needs one fails with the engine's own message.
pub fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| Gpu::open(None).unwrap_or_else(|error| panic!("{error}")))
}

/// `pipelines/gi.ron`.
///
/// # Panics
/// The file is at fault.
pub fn gi() -> Pipeline {
    Pipeline::load(&root().join("pipelines/gi.ron")).unwrap_or_else(|faults| panic!("{faults}"))
}

/// The plan of a pipeline for a scene.
///
/// # Panics
/// The pipeline or the request is at fault.
pub fn plan_for(pipeline: &Pipeline, scene: &Scene, request: &Request) -> Plan {
    let facts = SceneFacts::of(scene).unwrap_or_else(|faults| panic!("{faults}"));
    voxlume::plan(pipeline, &facts, &Registry::builtin(), request).unwrap_or_else(|faults| panic!("{faults}"))
}

/// Renders one frame from the scene's first camera.
///
/// # Panics
/// The plan is at fault, or the device.
pub fn render(pipeline: &Pipeline, scene: &Scene, request: &Request) -> Renderer<'static> {
    let plan = plan_for(pipeline, scene, request);
    let mut renderer = Renderer::new(gpu(), plan, scene).unwrap_or_else(|error| panic!("{error}"));
    let rendered = renderer.render(scene, &scene.cameras[0], Passes::All);
    rendered.unwrap_or_else(|error| panic!("{error}"));
    renderer
}

/// An image of the last frame.
///
/// # Panics
/// There is no such image, or the device is lost.
pub fn picture(renderer: &Renderer<'_>, name: &str) -> Picture {
    renderer.picture(name).unwrap_or_else(|error| panic!("{error}"))
}

/// An image of `gi` from the scene's first camera, 32 × 32 pixels, with these parameters: pass, name, value.
///
/// # Panics
/// The scene is at fault, or the device.
pub fn image(scene: &Scene, output: &str, resolution: u32, set: &[(&str, &str, f64)]) -> Picture {
    let number = |(pass, name, value): &(&str, &str, f64)| {
        ((*pass).to_owned(), (*name).to_owned(), Value::Number(*value))
    };
    let request = Request {
        resolution: Some(resolution),
        output: Some(output.into()),
        set: set.iter().map(number).collect(),
        ..Request::image(32, 32)
    };
    picture(&render(&gi(), scene, &request), output)
}

/// The mean of each of an image's first three channels.
pub fn mean(picture: &Picture) -> [f64; 3] {
    let sum = |channel: usize| picture.pixels.iter().map(|pixel| f64::from(pixel[channel])).sum::<f64>();
    [0, 1, 2].map(|channel| sum(channel) / picture.pixels.len() as f64)
}
