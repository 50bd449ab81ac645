//! `voxlume reference`.

use std::path::PathBuf;
use std::sync::Mutex;

use voxlume::{Picture, Reference, Request, Scene, SceneFacts};
use voxlume_measure::Progress as _;
use voxlume_measure::effect::Effect;
use voxlume_measure::outfile::{self, OutFile};
use voxlume_measure::picture::Kind;
use voxlume_reference::{Error, PixelSampling, Reflection, Tracer};

use crate::Registry;
use crate::args::{seconds, size};
use crate::failure::Failure;
use crate::interrupt;
use crate::pipeline;
use crate::progress::Progress;

/// Path-trace the ground truth of a scene or of one effect on the CPU
///
/// Pixels are sampled over their area. Prints the mean and the standard error. PNG and EXR are as `voxlume render`
/// writes them. Ambient occlusion has the reach and falloff of the pipeline `gi`; a soft shadow is that of the
/// first light.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume reference scenes/cornell.ron -o cornell.exr
  voxlume reference scenes/cornell.ron --effect diffuse --bounces 2 --spp 256 -o diffuse.png")]
pub struct Args {
    /// Scene file: .ron, .gltf or .glb
    scene: PathBuf,

    /// Camera of the scene; the first one unless given
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,

    /// Second of the scene's animation to show
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, allow_negative_numbers = true, value_parser = seconds)]
    time: f64,

    /// What to compute
    #[arg(long, default_value = "final", value_parser = Reference::WORDS.map(|(word, _)| word))]
    effect: String,

    /// Bounces of indirect light; 0 is direct light only
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(..=1000))]
    bounces: u32,

    /// Width and height of the image in pixels
    #[arg(long, value_name = "WxH", default_value = "512x512", value_parser = size)]
    size: [u32; 2],

    /// Samples of each pixel
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u32).range(2..))]
    spp: u32,

    /// File to write, by its extension .png or .exr; may be repeated
    #[arg(short, value_name = "FILE", required = true)]
    out: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    let files = args.out.iter().map(|path| Ok((Kind::of(path)?, OutFile::new(path)?)));
    let files: Vec<(Kind, OutFile)> = files.collect::<Result<_, voxlume::Fault>>()?;
    outfile::distinct(files.iter().map(|(_, file)| file))?;
    // From here on, so that it counts whenever it comes.
    interrupt::wish();
    let mut progress = Progress::new();
    progress.stage(format!("loading {}", args.scene.display()));
    let mut scene = Scene::load(&args.scene)?;
    scene.set_time(args.time);
    let camera = scene.camera(args.camera.as_deref())?.clone();
    let pipeline = pipeline::load("gi")?;
    let [width, height] = args.size;
    let facts = SceneFacts::of(&scene)?;
    // The plan tells the grid and which emitters are lights; its own size doesn't matter.
    let plan = voxlume::plan(&pipeline, &facts, registry, &Request::image(64, 64))?;
    let effects = Effect::all(&pipeline);
    let named = |effect: &&Effect<'_>| effect.name == args.effect;
    let effect = effects.iter().find(named).ok_or_else(|| Failure::work("`gi` has no such effect"))?;
    let quantity = effect.quantity(&pipeline, &plan, &scene, args.bounces)?;
    let quantity = quantity.ok_or_else(|| Failure::work("`gi` names no reference for it"))?;
    let request = voxlume_reference::Request {
        camera,
        width,
        height,
        samples: args.spp,
        seed: 0,
        sampling: PixelSampling::Area,
        quantity,
        reflection: Reflection::Gltf,
    };

    progress.stage("building the hierarchy".into());
    let traced = {
        let tracer = Tracer::new(&scene).map_err(refused)?;
        progress.stage(format!("tracing {} samples a pixel", args.spp));
        let progress = Mutex::new(&mut progress);
        let tell = |done| {
            if let Ok(mut progress) = progress.lock() {
                progress.share("tracing", done);
            }
        };
        tracer.render(&request, &tell, interrupt::wish()).map_err(refused)?
    };
    let (mean, error) = (mean(&traced.mean), rms(&traced.standard_error));
    let pixels = traced.mean.iter().map(|[r, g, b]| [*r, *g, *b, 1.0]).collect();
    let picture = Picture { width, height, pixels };
    let encoded = files
        .into_iter()
        .map(|(kind, file)| Ok((file, kind.encode(&picture, effect.shows, 1.0)?)))
        .collect::<Result<Vec<_>, Failure>>()?;
    outfile::write(&encoded)?;
    drop(progress);
    let line = |[r, g, b]: [f64; 3]| format!("{r:.6} {g:.6} {b:.6}");
    crate::print(&format!(
        "{} of {} · {width} × {height} pixels, {} samples each\nmean                        {}\nstandard error of a pixel   {} (root mean square)\n",
        args.effect,
        scene.name,
        args.spp,
        line(mean),
        line(error),
    ))
}

/// A request that can't be met is the user's fault; Ctrl-C is nobody's.
fn refused(error: Error) -> Failure {
    match error {
        Error::Cancelled => Failure::work("interrupted; nothing was written"),
        Error::NotFinite { .. } => Failure::work(error.to_string()),
        _ => voxlume::Fault::new(error.to_string()).into(),
    }
}

fn mean(pixels: &[[f32; 3]]) -> [f64; 3] {
    std::array::from_fn(|channel| {
        pixels.iter().map(|pixel| f64::from(pixel[channel])).sum::<f64>() / pixels.len() as f64
    })
}

fn rms(pixels: &[[f32; 3]]) -> [f64; 3] {
    std::array::from_fn(|channel| {
        let squares = pixels.iter().map(|pixel| f64::from(pixel[channel]).powi(2)).sum::<f64>();
        (squares / pixels.len() as f64).sqrt()
    })
}
