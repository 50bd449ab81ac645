//! Voxel cone tracing on `wgpu` with pluggable voxel storage formats.
//!
//! Load a scene and a pipeline, plan what the pipeline does for this scene, render the plan on a device:
//!
//! ```no_run
//! use voxlume::{Gpu, Passes, Pipeline, Registry, Renderer, Request, Scene, SceneFacts, plan};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let scene = Scene::load("scenes/cornell.ron".as_ref())?;
//! let pipeline = Pipeline::builtin("gi")?;
//! let facts = SceneFacts::of(&scene)?;
//! let plan = plan(&pipeline, &facts, &Registry::builtin(), &Request::image(512, 512))?;
//! let gpu = Gpu::open(None)?;
//! let mut renderer = Renderer::new(&gpu, plan, &scene)?;
//! renderer.render(&scene, &scene.cameras[0], Passes::Changed)?;
//! let picture = renderer.picture("final")?;
//! # Ok(())
//! # }
//! ```
//!
//! A [`Renderer`] submits its frames and waits for them. A program with a device and frames of its own keeps a [`Session`]
//! instead, which records into the program's encoder what has changed since the frame before:
//!
//! ```no_run
//! # use voxlume::{Frame, Gpu, Pipeline, Registry, Request, Scene, SceneFacts, Session, Value, plan, wgpu};
//! # fn embedded(device: wgpu::Device, queue: wgpu::Queue) -> Result<(), Box<dyn std::error::Error>> {
//! # let mut scene = Scene::load("scenes/cornell.ron".as_ref())?;
//! # let pipeline = Pipeline::builtin("gi")?;
//! # let plan = plan(&pipeline, &SceneFacts::of(&scene)?, &Registry::builtin(), &Request::image(512, 512))?;
//! let gpu = Gpu::new(device.clone(), queue.clone());
//! let mut session = Session::new(&gpu, plan, &scene)?;
//!
//! let mut encoder = device.create_command_encoder(&Default::default());
//! session.encode(&mut encoder, &Frame::of(&scene.cameras[0]))?;
//! let image = session.texture("final"); // to be sampled by what the program records next
//! queue.submit([encoder.finish()]);
//!
//! // Between two frames:
//! scene.cameras[0].eye.x += 0.1;
//! session.update(&scene)?; // things that move, lights, sky
//! session.set("diffuse", "step", &Value::Number(0.5))?;
//! session.resize(1024, 768)?;
//! # Ok(())
//! # }
//! ```
//!
//! # Scenes
//! | name | what it is |
//! |---|---|
//! | [`Scene`] | What is lit, what lights it and where it is seen from, loaded from glTF or RON or made in memory. |
//! | [`Camera`] | A pinhole and the way it looks. |
//! | [`scene`] | The other parts of a scene: meshes, materials, lights, paths; what RON and glTF files may hold. |
//!
//! # Pipelines and plans
//! | name | what it is |
//! |---|---|
//! | [`Pipeline`] | A RON file of passes, read but not yet checked against shaders, formats and a scene. |
//! | [`PIPELINES`] | The pipelines that come with Voxlume. |
//! | [`PassEntry`] | A pass as RON describes it. |
//! | [`Shows`] | What the values of a pass's image are, which says how a picture shows them. |
//! | [`Reference`] | The path tracer's quantity that a pass's image is held against. |
//! | [`Value`] | The value of a pass's parameter. |
//! | [`Extent`] | What space the grid takes: the scene's, or a given box. |
//! | [`DEFAULT_METHOD`] | How `voxelize` finds voxels unless told otherwise. |
//! | [`SceneFacts`] | What a scene needs, so that a plan models only that. |
//! | [`Emission`] | How what surfaces emit reaches others. |
//! | [`Request`] | What is asked for beside the pipeline: size, format, output, parameters. |
//! | [`Registry`] | What pipelines can name: formats, kinds of passes, tracers, and the WGSL of all. |
//! | [`plan`] | Checks a pipeline against a scene and gives the plan. |
//! | [`explain`] | A plan in words: passes, resources with their bytes, what was left out and why. |
//! | [`SCALES`] | What the screen's size may be divided by where an effect gathers. |
//! | [`check_variant`] | Whether the words of a format and of an encoding are known. |
//! | [`Plan`] | All that a device does for a pipeline on a scene, as data. |
//! | [`Pass`] | One pass of a plan: it runs whole or not at all. |
//! | [`Sources`] | What a pass depends on beside the resources that other passes make. |
//! | [`Update`] | When a pass runs. |
//! | [`ParamSlot`] | A parameter's place in its pass's uniform buffer. |
//! | [`ParamBytes`] | New bytes for a parameter. |
//! | [`LeftOut`] | A pass or resource that the scene doesn't need, and why. |
//! | [`Grid`] | The grid of voxels that a plan uses. |
//! | [`Step`] | One dispatch, draw or clear of a plan. |
//! | [`Touch`] | A resource in a step, and how the step uses it. |
//! | [`Groups`] | The workgroups of a dispatch. |
//! | [`Vertices`] | The vertices of a step that rasterizes. |
//! | [`Program`] | A shader with what its variables are bound to. |
//! | [`Bind`] | One variable of a program. |
//! | [`Target`] | What a variable is bound to. |
//! | [`Resource`] | A buffer or texture of a plan. |
//! | [`ResourceKind`] | Its kind and size. |
//! | [`ImageExtent`] | The size of an image. |
//! | [`ImageTexel`] | The texel of an image. |
//! | [`Life`] | How long a resource's value is kept. |
//!
//! # Kinds of passes
//! | name | what it is |
//! |---|---|
//! | [`Kinds`] | The kinds of passes that a pipeline can name; others are added to the built-in ones. |
//! | [`PassKind`] | A kind of pass: what it reads and makes, when it is left out, how it becomes steps. |
//! | [`Port`] | Something that a kind reads, makes or changes. |
//! | [`Sort`] | What sort of thing a port is. |
//! | [`ParamWords`] | A parameter that decides what is planned. |
//! | [`Values`] | The values that such a parameter can have. |
//! | [`Idle`] | Why an entry has nothing to do. |
//! | [`Unread`] | A port that an entry doesn't look at, and why. |
//! | [`Expansion`] | One entry of a pipeline on its way to steps. |
//! | [`Bundle`] | What a name of the graph stands for in shaders: variables, constants, modules. |
//! | [`Run`] | A step on its way. |
//! | [`Over`] | What a compute step runs over. |
//! | [`screen_image`] | An image of the screen's size. |
//!
//! # Tracers
//! | name | what it is |
//! |---|---|
//! | [`Tracers`] | The tracers to choose from; others are added to the built-in ones. |
//! | [`Tracer`] | A way to find what lies in a direction: its WGSL modules and what it looks at. |
//! | [`CONES`], [`RAYS`] | The tracers that come with Voxlume. |
//!
//! # Devices and frames
//! | name | what it is |
//! |---|---|
//! | [`Gpu`] | An open device: one of its own, or another program's. |
//! | [`Session`] | A scene on a device, and a plan that is recorded into another program's frames. |
//! | [`Frame`] | What a frame shows, and what it runs. |
//! | [`Counters`] | What a session has had its device do: compilations, uploads, passes. |
//! | [`Renderer`] | A session whose frames are submitted, timed and waited for. |
//! | [`Passes`] | Which passes a frame runs. |
//! | [`Picture`] | An image read back: linear values, row by row. |
//! | [`Texels`] | A level of a volume read back. |
//! | [`PassTime`] | How long a pass took. |
//! | [`Clock`] | Which clock took that time. |
//! | [`OutOfRange`] | How many values an encoding could not hold, and the worst. |
//! | [`Error`] | What a device refuses. |
//! | [`wgpu`] | The version of `wgpu` that all this is built with. |
//!
//! # Storage formats
//! | name | what it is |
//! |---|---|
//! | [`Formats`] | The formats to choose from; others are added to the built-in ones. |
//! | [`StorageFormat`] | A format: its volumes, its WGSL modules, its options. |
//! | [`Isotropic`], [`SixFace`], [`Sh2`] | The built-in formats. |
//! | [`Encodings`] | The encodings to choose from; others are added to the built-in ones. |
//! | [`Encoding`] | How the numbers of a format are stored. |
//! | [`Texel`] | Texels of four numbers that every device can write and read. |
//! | [`Volume`] | A 3D texture of a format. |
//! | [`Levels`] | Which of the grid's levels a volume holds. |
//! | [`Numbers`] | What the numbers of a volume's texels are. |
//! | [`FormatOption`] | A choice that a format leaves open. |
//! | [`Choices`] | The words chosen for a format's options. |
//! | [`Property`] | A property that the conformance suite measures. |
//! | [`Miss`] | A property that a format can't hold, and by how much. |
//! | [`Twin`] | A format's functions on the CPU in `f64`, to hold its WGSL against. |
//! | [`twin`] | What twins are built from. |
//! | [`probe`] | A plan that fills a volume and samples it, for the conformance suite. |
//! | [`ProbeSize`] | How much a probe holds. |
//!
//! # Shaders
//! | name | what it is |
//! |---|---|
//! | [`Library`] | WGSL modules by path; others are added to the built-in ones. |
//! | [`link`] | Makes one text of a module and all that it imports. |
//! | [`Linked`] | That text, to be checked. |
//! | [`check_all`] | Checks every module of a library in every way that it can be linked. |
//!
//! # Faults
//! | name | what it is |
//! |---|---|
//! | [`Fault`] | What is wrong with a file or request, where, and what would be valid. |
//! | [`Faults`] | All faults of an input at once. |
//! | [`Place`] | Where a fault is. |
//! | [`Source`] | A text and its name. |
//! | [`nearest`], [`one_of`] | Choices as messages give them. |

pub use voxlume_engine::{
    Clock, Counters, Error, Frame, Gpu, OutOfRange, PassTime, Passes, Picture, Renderer, Session, Texels,
};
pub use voxlume_fault::{Fault, Faults, Place, Source, nearest, one_of};
pub use voxlume_format::{
    Choices, Encoding, Encodings, FormatOption, Formats, Isotropic, Levels, Miss, Numbers, Property, Sh2,
    SixFace, StorageFormat, Texel, Twin, Volume, twin,
};
pub use voxlume_graph::{
    Bind, Bundle, CONES, DEFAULT_METHOD, Emission, Expansion, Extent, Grid, Groups, Idle, ImageExtent,
    ImageTexel, Kinds, LeftOut, Life, Over, PIPELINES, ParamBytes, ParamSlot, ParamWords, Pass, PassEntry,
    PassKind, Pipeline, Plan, Port, ProbeSize, Program, RAYS, Reference, Registry, Request, Resource,
    ResourceKind, Run, SCALES, SceneFacts, Shows, Sort, Sources, Step, Target, Touch, Tracer, Tracers,
    Unread, Update, Value, Values, Vertices, check_variant, explain, plan, probe, screen_image,
};
pub use voxlume_scene as scene;
pub use voxlume_scene::{Camera, Scene};
pub use voxlume_shader::{Library, Linked, check_all, link};
pub use wgpu;

#[cfg(test)]
mod tests {
    /// Every name that is exported has its sentence above; rustdoc sees to it that every name above is exported.
    #[test]
    fn every_export_has_a_sentence() {
        let (docs, exports) = include_str!("lib.rs").split_once("\npub use ").unwrap_or_default();
        let exports = exports.split("#[cfg(test)]").next().unwrap_or_default();
        let words = exports.split(|c: char| !(c.is_alphanumeric() || c == '_'));
        let names = words.filter(|word| {
            !(word.is_empty() || word.starts_with("voxlume_") || ["pub", "use", "as"].contains(word))
        });
        let missing: Vec<&str> = names.filter(|name| !docs.contains(&format!("[`{name}`]"))).collect();
        assert!(docs.contains("# Faults") && missing.is_empty(), "{missing:?}");
    }
}
