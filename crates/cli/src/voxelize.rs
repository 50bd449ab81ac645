//! `voxlume voxelize`.

mod cells;
mod file;
mod ply;
mod report;
mod vox;

use std::path::PathBuf;
use std::time::Instant;

use voxlume::{DEFAULT_METHOD, Gpu, Passes, Pipeline, Renderer, Value};
use voxlume_measure::outfile::{self, OutFile};
use voxlume_measure::{Frames, Progress as _, channel_shows};

use crate::Registry;
use crate::args::{self, PlanArgs};
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use crate::render::exposure;
use cells::Cells;
use file::Kind;
use report::Report;

/// Voxelize a scene, and write the voxels as a picture, as points or as a model
///
/// A PNG or EXR shows the occupied voxels of a level as cubes from a camera, in one channel; alpha is 1 where there
/// is a voxel. PNGs encode each channel as `voxlume render` encodes the image of that name: light is tone-mapped,
/// albedo sRGB-encoded, a normal shown as n/2 + 1/2, occupancy and opacity clamped to [0, 1]. A PLY (binary, little
/// endian) has a vertex for each occupied voxel: its centre in the world, the mean normal (zero where opposite
/// surfaces cancel) and the channel as a PNG shows it. A VOX is for MagicaVoxel, which has z upwards: models of at
/// most 256³ voxels with the channel in 255 colours.
///
/// Albedo, normal, occupancy and emission need nothing but the voxels. Opacity, radiance and lit show the pipeline's
/// volume, in its storage format, at the cells' centres: opacity and radiance as seen from the side `--direction`,
/// lit as seen from the camera. Coarser levels show the mean of what is occupied below.
///
/// The hashes are BLAKE3 of the words of level 0's bitmask and of the attribute sums, for comparing runs bit by bit.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume voxelize scenes/cornell.ron --resolution 64 -o cornell.png
  voxlume voxelize scenes/cornell.ron --channel normal --level 2 -o normals.png
  voxlume voxelize scenes/cornell.ron --format six_face --channel radiance --direction +x -o from_right.exr
  voxlume voxelize scenes/cornell.ron --channel albedo --resolution 256 -o cornell.vox -o cornell.ply
  voxlume voxelize scenes/cornell.ron --method fragment --separability thin --repeat 20 --json thin.json")]
pub struct Args {
    #[command(flatten)]
    plan: PlanArgs,

    /// How triangles are voxelized, instead of as the pipeline says; all methods set the same bits
    #[arg(long, value_parser = ["triangle", "fragment", "hybrid", "balanced"])]
    method: Option<String>,

    /// Which voxels a surface takes, instead of the pipeline's: thin (6-separable) or conservative (26-separable,
    /// all that it overlaps)
    #[arg(long, value_name = "WORD")]
    separability: Option<String>,

    /// Level to show: 0 is the finest, each further one half as fine
    #[arg(long, value_name = "N", default_value_t = 0)]
    level: u32,

    /// What of the voxels to show
    #[arg(long, default_value = "lit", value_parser = ["albedo", "normal", "occupancy", "emission", "opacity", "radiance", "lit"])]
    channel: String,

    /// The side from which opacity and radiance are seen
    #[arg(long, value_name = "SIDE", default_value = "+z", allow_hyphen_values = true, value_parser = ["+x", "-x", "+y", "-y", "+z", "-z"])]
    direction: String,

    /// Camera of the scene; the first one unless given
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,

    /// Part of the name of the graphics device to use; see `voxlume devices`
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,

    /// Times to voxelize, after one of warm-up
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    repeat: u32,

    /// Exposure of light in stops, in all files but EXR
    #[arg(long, value_name = "EV", default_value_t = 0.0, allow_negative_numbers = true, value_parser = exposure)]
    exposure: f32,

    /// File to write, by its extension .png, .exr, .ply or .vox; may be repeated
    #[arg(short, value_name = "FILE")]
    out: Vec<PathBuf>,

    /// File to write counts, hashes, times and bytes to
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    interrupt::wish();
    let files = args.out.iter().map(|path| Ok((Kind::of(path)?, OutFile::new(path)?)));
    let files: Vec<(Kind, OutFile)> = files.collect::<Result<_, voxlume::Fault>>()?;
    let json = args.json.as_deref().map(OutFile::new).transpose()?;
    outfile::distinct(files.iter().map(|(_, file)| file).chain(&json))?;
    let mut pipeline = args.plan.pipeline()?;
    if let Some(word) = &args.separability {
        pipeline.separability.value.clone_from(word);
        pipeline.separability.span = None;
    }

    let mut progress = Progress::new();
    progress.stage(format!("loading {}", args.plan.scene.display()));
    let scene = args.plan.scene()?;
    let camera = scene.camera(args.camera.as_deref())?;
    progress.stage("planning".into());
    let plan = args::plan(registry, &pipeline, &scene, &request(args, &pipeline))?;
    let gpu = Gpu::open(args.adapter.as_deref())?;
    let mut renderer = Renderer::new(&gpu, plan, &scene)?;
    progress.stage("voxelizing".into());
    renderer.render(&scene, camera, Passes::All)?;
    let mut frames = Frames::default();
    for run in 1..=args.repeat {
        interrupt::heed()?;
        progress.repeated(format!("voxelizing {run}/{}", args.repeat));
        let start = Instant::now();
        let mut times = renderer.render(&scene, camera, Passes::All)?;
        times.retain(|time| pipeline.passes.iter().any(|p| p.name == time.name && p.run.value == "voxelize"));
        frames.push(times, start.elapsed().as_secs_f64() * 1e3);
    }

    progress.stage("writing".into());
    let asked = args.method.clone().or_else(|| method(&pipeline)).unwrap_or(DEFAULT_METHOD.into());
    let report = Report::new(&gpu, &scene, (&pipeline, asked), &renderer, &frames)?;
    let mut written = Vec::new();
    let scale = args.exposure.exp2();
    let cells = match files.iter().any(|(kind, _)| !kind.is_picture()) {
        true => Some(Cells::read(&renderer, args.level, &args.channel, scale)?),
        false => None,
    };
    for (kind, file) in files {
        let bytes = match (kind, &cells) {
            (Kind::Ply, Some(cells)) => ply::encode(cells, &renderer.plan().grid),
            (Kind::Vox, Some(cells)) => vox::encode(cells, renderer.plan().grid.size)?,
            (Kind::Picture(kind), _) => {
                let name = &renderer.plan().resources[renderer.plan().output].name;
                kind.encode(&renderer.picture(name)?, channel_shows(&args.channel), scale)?
            }
            (Kind::Ply | Kind::Vox, None) => continue,
        };
        written.push((file, bytes));
    }
    if let Some(file) = json {
        let text = serde_json::to_string_pretty(&report).map_err(|error| Failure::work(error.to_string()))?;
        written.push((file, (text + "\n").into_bytes()));
    }
    outfile::write(&written)?;
    drop(progress);
    crate::print(&report.tables())
}

/// The pipeline's view of the voxels, with the channel, level and direction asked for.
fn request(args: &Args, pipeline: &Pipeline) -> voxlume::Request {
    let mut request = args.plan.request();
    let view = pipeline.passes.iter().find(|pass| pass.run.value == "voxel_view");
    let (name, image) = match view {
        Some(view) => (view.name.as_str(), view.writes.first().map_or("voxel_view", |image| &image.value)),
        // Told by the planner as an output that nobody makes.
        None => ("", "voxel_view"),
    };
    request.output = Some(image.to_owned());
    let voxelizes = pipeline.passes.iter().find(|pass| pass.run.value == "voxelize");
    let method = voxelizes.zip(args.method.as_ref());
    let method = method.map(|(pass, word)| (pass.name.clone(), "method".into(), Value::Word(word.clone())));
    request.set.extend(method);
    if !args.out.iter().any(|path| Kind::of(path).is_ok_and(Kind::is_picture)) {
        request.screen = [1, 1];
    }
    if view.is_some() {
        // Where nothing is written, nothing has to be lit.
        let channel = if args.out.is_empty() { "occupancy" } else { &args.channel };
        let along = |axis: char| match args.direction.split_at(1) {
            ("-", own) if own.starts_with(axis) => -1.0,
            (_, own) if own.starts_with(axis) => 1.0,
            _ => 0.0,
        };
        let set = [
            ("channel", Value::Word(channel.to_owned())),
            ("level", Value::Number(args.level.into())),
            ("direction", Value::Vector(['x', 'y', 'z'].map(along).to_vec())),
        ];
        request.set.extend(set.map(|(param, value)| (name.to_owned(), param.to_owned(), value)));
    }
    request
}

/// How the pipeline says that triangles are voxelized.
fn method(pipeline: &Pipeline) -> Option<String> {
    let pass = pipeline.passes.iter().find(|pass| pass.run.value == "voxelize")?;
    match &pass.params.iter().find(|param| param.name == "method")?.value {
        Value::Word(word) => Some(word.clone()),
        _ => None,
    }
}
