//! Voxel cone tracing on `wgpu` with pluggable voxel storage formats.
//!
//! ```no_run
//! use voxlume::{Gpu, Passes, Pipeline, Registry, Renderer, Request, Scene, SceneFacts, plan};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::load("scenes/cornell.ron".as_ref())?;
//! let pipeline = Pipeline::load("pipelines/gi.ron".as_ref())?;
//! let facts = SceneFacts::of(&scene)?;
//! let plan = plan(&pipeline, &facts, &Registry::builtin(), &Request::image(512, 512))?;
//! let gpu = Gpu::open(None)?;
//! let mut renderer = Renderer::new(&gpu, plan, &scene)?;
//! renderer.render(&scene, &scene.cameras[0], Passes::Changed)?;
//! let picture = renderer.picture("final")?;
//! # Ok(())
//! # }
//! ```

pub use voxlume_engine::{Clock, Error, Gpu, OutOfRange, PassTime, Passes, Picture, Renderer, Texels};
pub use voxlume_fault::{Fault, Faults, Place, Source, nearest, one_of};
pub use voxlume_format::{
    Choices, Encoding, Encodings, FormatOption, Formats, Isotropic, Levels, Miss, Numbers, Property, Sh2,
    SixFace, StorageFormat, Texel, Twin, Volume, twin,
};
pub use voxlume_graph::{
    Bind, CONES, DEFAULT_METHOD, Extent, Grid, KINDS, Kind, LeftOut, PassEntry, Pipeline, Plan, ProbeSize,
    Program, Registry, Request, Resource, ResourceKind, SURFACE_IMAGES, SceneFacts, Step, Target, Tracer,
    Tracers, Value, check_variant, explain, plan, probe,
};
pub use voxlume_scene as scene;
pub use voxlume_scene::{Camera, Scene};
pub use voxlume_shader::{Library, Linked, check_all, link};
pub use wgpu;
