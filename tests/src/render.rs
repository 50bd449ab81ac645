//! Plans and frames on the one device of a test program.
#![allow(clippy::panic)]

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use voxlume::{Gpu, Passes, Picture, Pipeline, Plan, Registry, Renderer, Request, Scene, SceneFacts};

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
