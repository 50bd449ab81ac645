//! `voxlume compare`.

use std::path::{Path, PathBuf};

use voxlume::Fault;
use voxlume::Registry;
use voxlume_measure::compare::{Sweep, suite};
use voxlume_measure::{Error, Progress as _, Settings};
use voxlume_report::{Overview, Results, against, table};

use crate::args::size;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::{interrupt, pipeline};

/// Hold effects against a path tracer: what each storage format and tracer costs, and how wrong it is
///
/// For every scene, effect, format, encoding, tracer, resolution and scale: the time of each pass, the bytes of the volume, and
/// RMSE, relative MSE, signed bias, 99th percentile and FLIP against the reference. Writes results.json, results.csv,
/// report.html (one page, works offline) and images/ into the folder --out. A cell that is finished there is not
/// run again unless something that decides it has changed.
///
/// Compared are pixels in which both show a surface; emitters count only in `final`, or where there is nothing else.
/// An effect whose entry names no `reference` is held against itself, in the first format, encoding, tracer and scale at
/// the finest resolution given.
///
/// The reference looks through pixels' centres, as the renderer does, textures included, and reflects as glTF says. Its own noise is taken
/// off RMSE and relative MSE; where it is over a fifth of the RMSE a note says so, and more --spp helps.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume compare scenes/cornell.ron --out cornell
  voxlume compare scenes/cornell.ron --formats isotropic,sh2 --resolutions 64 --effects diffuse,final --out two
  voxlume compare scenes/cornell.ron --tracers all --resolutions 128 --scales 1,2 --out tracers
  voxlume compare --suite open_scenes --baseline benches/suite.json --out suite
  voxlume compare scenes/*.ron --spp 2048 --repeat 20 --out all
  voxlume compare scenes/cornell.ron --baseline cornell/results.json --out changed")]
pub struct Args {
    /// Scene files: .ron, .gltf or .glb
    #[arg(value_name = "SCENE", required_unless_present = "suite")]
    scenes: Vec<PathBuf>,

    /// Five open scenes from a folder, cornell.glb, cornell_double_sided.glb, cornell_blender.glb, sponza_lite.glb and
    /// sibenik.glb, with every tracer, at 128 voxels and 256x144 pixels unless given; marks what is out of its bound
    #[arg(long, value_name = "FOLDER", conflicts_with = "scenes")]
    suite: Option<PathBuf>,

    /// Storage formats with commas between, or all; options follow a name, such as sh2:mip=projected:negatives=window
    #[arg(long, value_name = "LIST", default_value = "all", value_delimiter = ',')]
    formats: Vec<String>,

    /// Texel encodings with commas between, or all; the pipeline's unless given; rgba8:range=8 declares a range
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    encodings: Vec<String>,

    /// Tracers with commas between (cones, rays), or all; the pipeline's unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    tracers: Vec<String>,

    /// Voxels along the grid's side; 32,64,128 unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    resolutions: Vec<u32>,

    /// What the screen's size is divided by where tracing effects gather, with commas between: 1, 2, 4 or 8; as the
    /// pipeline says unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    scales: Vec<u32>,

    /// Effects with commas between, or all that a scene has: names of the pipeline's effects, and final; of gi
    /// soft_shadow, ambient_occlusion, diffuse, specular, final
    #[arg(long, value_name = "LIST", default_value = "all", value_delimiter = ',')]
    effects: Vec<String>,

    /// Camera of every scene; the first one unless given
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,

    /// Width and height of the images in pixels; 256x256 unless given
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,

    /// The reference's samples of each pixel
    #[arg(long, value_name = "N", default_value_t = 512, value_parser = clap::value_parser!(u32).range(2..))]
    spp: u32,

    /// Frames to time, after one of warm-up
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    repeat: u32,

    /// Part of the name of the graphics device to use; see `voxlume devices`
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,

    /// Name of a built-in pipeline (gi, rauwendaal), or a .ron file
    #[arg(long, value_name = "NAME|FILE", default_value = "gi")]
    pipeline: String,

    /// The results.json of another time, to print how times and errors have changed since
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,

    /// Folder for the results; made if it isn't there
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    let stop = interrupt::wish();
    let pipeline = pipeline::load(&args.pipeline)?;
    let mut progress = Progress::new();
    progress.stage("loading".into());
    let baseline = args.baseline.as_deref().map(baseline).transpose()?;
    let suite = args.suite.is_some();
    let scenes = args.suite.as_deref().map_or_else(|| Ok(args.scenes.clone()), suite::scenes)?;
    let bounds = if suite { suite::bounds() } else { Vec::new() };
    let unless =
        |given: &[u32], usual: &[u32]| if given.is_empty() { usual.to_vec() } else { given.to_vec() };
    let all = || vec!["all".to_owned()];
    let sweep = Sweep {
        settings: Settings {
            registry,
            pipeline: &pipeline,
            formats: args.formats.clone(),
            encodings: args.encodings.clone(),
            tracers: if suite && args.tracers.is_empty() { all() } else { args.tracers.clone() },
            resolutions: unless(&args.resolutions, if suite { &[128] } else { &[32, 64, 128] }),
            scales: args.scales.clone(),
            size: args.size.unwrap_or(if suite { [256, 144] } else { [256, 256] }),
            adapter: args.adapter.clone(),
        },
        scenes,
        bounds: bounds.clone(),
        camera: args.camera.clone(),
        effects: args.effects.clone(),
        samples: args.spp,
        repeat: args.repeat,
        folder: args.out.clone(),
    };
    let results = sweep.run(&mut progress, stop).map_err(|error| match error {
        Error::Interrupted { .. } => {
            let out = args.out.display();
            Failure::work(format!("{error} and kept in `{out}`; the same command goes on from there"))
        }
        error => error.into(),
    })?;
    drop(progress);
    crate::print(&table(&results))?;
    if let Some(overview) = Overview::of(&results, &bounds) {
        crate::print(&format!("\nall scenes, bias over the mean and RMSE:\n{}", overview.text()))?;
        if suite {
            crate::print(&format!("{} figures are out of their bounds\n", overview.out_of_bounds()))?;
        }
    }
    if let Some(baseline) = baseline {
        crate::print(&format!("\nsince the baseline:\n{}", against(&results, &baseline)))?;
    }
    match results.failed() {
        0 => Ok(()),
        failed => Err(Failure::work(format!(
            "{failed} of {} cells failed; results.json says why",
            results.rows.len()
        ))),
    }
}

/// Reads the results of another time.
fn baseline(path: &Path) -> Result<Results, Fault> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| Fault::new(format!("cannot read `{}`: {error}", path.display())))?;
    Results::parse(&text).map_err(|error| Fault::new(format!("`{}`: {error}", path.display())))
}
