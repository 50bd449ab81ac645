//! `voxlume render`.

mod frames;

use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;

use voxlume::{Fault, Gpu, Passes, Renderer, Scene};
use voxlume_measure::outfile::{self, OutFile};
use voxlume_measure::picture::Kind;
use voxlume_measure::{Frames, Progress as _, describe, shows};
use voxlume_report::OutOfRange;

use crate::Registry;
use crate::args::ImageArgs;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use crate::timing::{Report, Resource};

/// Render a scene to PNG and EXR, and tell what it cost
///
/// A PNG is for the eye: images of light are multiplied by 2^EV (--exposure), tone-mapped (Reinhard et al. 2002, eq. 4,
/// on luminance, white at 4) and sRGB-encoded; albedo is only sRGB-encoded; normal and geometry are shown as
/// n/2 + 1/2; depth is clamped to [0, 1]. An effect's image is shown as `shows` in its entry says: light, share (clamped
/// to [0, 1]), normal or albedo. An EXR has the linear values as computed, in 32-bit float,
/// with alpha as the pass left it (final: 1 on surfaces, 0 in the sky; shadow: the fourth light).
///
/// Every timed frame runs all passes, also those, such as voxelize, that a still scene needs only once.
///
/// With `--frames A..B` the scene's animation is rendered, from frame A on up to the one before B, each to a file with its
/// number: frame N shows the scene at N/FPS seconds. Then only passes run whose result may have changed. The time
/// of each is over the frames that ran it, and the passes that ran are listed for each frame.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume render scenes/cornell.ron -o cornell.png
  voxlume render scenes/cornell.ron --format six_face -o cornell.png -o cornell.exr
  voxlume render scenes/cornell.ron --output ao -o ao.png
  voxlume render scenes/cornell.ron --set bounce.bounces=1 --exposure 0.5 -o bright.png
  voxlume render scenes/moving.ron --frames 0..48 -o out/frame_{:04}.png --json out/times.json
  voxlume render scenes/moving.ron --time 0.5 --output voxel_view -o voxels.png
  voxlume render scenes/cornell.ron --size 640x360 --repeat 20 -o cornell.png --json cornell.json")]
pub struct Args {
    #[command(flatten)]
    image: ImageArgs,

    /// Camera of the scene; the first one unless given
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,

    /// Part of the name of the graphics device to use; see `voxlume devices`
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,

    /// Frames to time, after one of warm-up
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    repeat: u32,

    /// Frames of the animation to render, numbered from A to B - 1; each -o then has a `{}` or, say, `{:04}` in its name
    #[arg(long, value_name = "A..B", conflicts_with_all = ["repeat", "time"], value_parser = frames::numbers)]
    frames: Option<Range<u32>>,

    /// Frames a second of the animation, 24 unless given
    #[arg(long, value_name = "N", requires = "frames", value_parser = frames::rate)]
    fps: Option<f64>,

    /// Exposure of PNGs in stops
    #[arg(long, value_name = "EV", default_value_t = 0.0, allow_negative_numbers = true, value_parser = exposure)]
    exposure: f32,

    /// File to write, by its extension .png or .exr; may be repeated
    #[arg(short, value_name = "FILE", required = true)]
    out: Vec<PathBuf>,

    /// File to write times and bytes to
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Stops of exposure.
pub fn exposure(text: &str) -> Result<f32, String> {
    let stops = text.parse().ok().filter(|stops: &f32| stops.abs() <= 100.0);
    stops.ok_or_else(|| "a number from -100 to 100".into())
}

/// Runs the command.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    if let Some(range) = &args.frames {
        return frames::run(args, registry, range);
    }
    interrupt::wish();
    // What can be refused at once is, before the long work.
    let pictures = args.out.iter().map(|path| Ok((Kind::of(path)?, OutFile::new(path)?)));
    let pictures: Vec<(Kind, OutFile)> = pictures.collect::<Result<_, Fault>>()?;
    let times = args.json.as_deref().map(OutFile::new).transpose()?;
    outfile::distinct(pictures.iter().map(|(_, file)| file).chain(&times))?;
    let pipeline = args.image.plan.pipeline()?;

    let mut progress = Progress::new();
    progress.stage(format!("loading {}", args.image.plan.scene.display()));
    let scene = args.image.plan.scene()?;
    let camera = scene.camera(args.camera.as_deref())?;
    progress.stage("planning".into());
    // Faults first: a device takes its time to open, or may not be there.
    args.image.plan(registry, &pipeline, &scene, None)?;
    let gpu = Gpu::open(args.adapter.as_deref())?;
    let plan = args.image.plan(registry, &pipeline, &scene, Some(&gpu))?;

    progress.stage(format!("compiling {} passes", plan.passes.len()));
    let mut renderer = Renderer::new(&gpu, plan, &scene)?;
    progress.stage("rendering".into());
    renderer.render(&scene, camera, Passes::All)?;
    let mut frames = Frames::default();
    for frame in 1..=args.repeat {
        interrupt::heed()?;
        progress.repeated(format!("rendering frame {frame}/{}", args.repeat));
        let start = Instant::now();
        let times = renderer.render(&scene, camera, Passes::All)?;
        frames.push(times, start.elapsed().as_secs_f64() * 1e3);
    }

    progress.stage("writing".into());
    let clamped = renderer.out_of_range()?;
    let report = report(&gpu, &scene, &renderer, &frames, clamped);
    let name = &renderer.plan().resources[renderer.plan().output].name;
    let picture = renderer.picture(name)?;
    let shows = shows(&pipeline, &args.image.plan.set, name);
    let mut files = Vec::new();
    for (kind, file) in pictures {
        files.push((file, kind.encode(&picture, shows, args.exposure.exp2())?));
    }
    if let Some(file) = times {
        files.push((file, json(&report)?));
    }
    outfile::write(&files)?;
    drop(progress);
    let clamped = clamped.map(|clamped| format!("\nnote: {clamped}\n")).unwrap_or_default();
    crate::print(&(report.tables(&frames) + &clamped))
}

fn json(report: &Report) -> Result<Vec<u8>, Failure> {
    let text = serde_json::to_string_pretty(report).map_err(|error| Failure::work(error.to_string()))?;
    Ok((text + "\n").into_bytes())
}

fn report(
    gpu: &Gpu,
    scene: &Scene,
    renderer: &Renderer<'_>,
    frames: &Frames,
    clamped: Option<voxlume::OutOfRange>,
) -> Report {
    let plan = renderer.plan();
    Report {
        schema: 1,
        device: describe(&gpu.info),
        scene: scene.name.clone(),
        format: plan.format.clone(),
        encoding: plan.encoding.to_string(),
        resolution: plan.grid.size.into_iter().max().unwrap_or(0),
        passes: frames.passes(),
        total_ms: frames.total().0,
        resources: renderer.bytes().into_iter().map(|(name, bytes)| Resource { name, bytes }).collect(),
        occupied_voxels: renderer.counts().0,
        out_of_range: clamped.map(|clamped| OutOfRange { texels: clamped.values, worst: clamped.worst }),
        frames: None,
    }
}
