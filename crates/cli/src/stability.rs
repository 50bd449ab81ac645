//! `voxlume stability`.

use std::path::PathBuf;

use voxlume::Registry;
use voxlume_measure::outfile::{self, OutFile};
use voxlume_measure::stability::{Ran, Suite, cases};
use voxlume_measure::{Error, Settings};
use voxlume_report::{Stability, stability_page, utc_now};

use crate::args::size;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::table::Table;
use crate::{interrupt, pipeline};

/// Run hard cases: numerical stability as figures with bounds
///
/// Each case is a small scene that breaks renderers, with a property that should hold; a figure says how far it does. Ends with
/// exit code 1 if a figure is out of its bound and that is not a known miss. The book's page on stability says what each
/// case measures, and why some can't hold.
///
/// --json writes {"schema": 1, "device": {…}, "rows": [{"case", "format", "encoding", "tracer", "resolution", "figure", "value", "bound", "pass"}]};
/// a bound of null means that the figure is only measured.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume stability --list
  voxlume stability --json stability.json --html stability.html
  voxlume stability leak furnace --tracers all
  voxlume stability leak leak_sun --formats six_face,sh2 --resolutions 64")]
pub struct Args {
    /// Cases; all unless given
    #[arg(value_name = "CASE")]
    cases: Vec<String>,

    /// List the cases and what should hold of each
    #[arg(long)]
    list: bool,

    /// Storage formats with commas between, or all
    #[arg(long, value_name = "LIST", default_value = "all", value_delimiter = ',')]
    formats: Vec<String>,

    /// Texel encodings with commas between, or all
    #[arg(long, value_name = "LIST", default_value = "rgba16float", value_delimiter = ',')]
    encodings: Vec<String>,

    /// Tracers with commas between (cones, rays), or all; the pipeline's unless given
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    tracers: Vec<String>,

    /// Voxels along the grid's side, instead of each case's own
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    resolutions: Vec<u32>,

    /// Width and height of the images in pixels
    #[arg(long, value_name = "WxH", default_value = "64x64", value_parser = size)]
    size: [u32; 2],

    /// Part of the name of the graphics device to use; see `voxlume devices`
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,

    /// File for all figures
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    /// File for a page with curves and all figures
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    if args.list {
        return list();
    }
    let stop = interrupt::wish();
    let json = args.json.as_deref().map(OutFile::new).transpose()?;
    let html = args.html.as_deref().map(OutFile::new).transpose()?;
    outfile::distinct(json.iter().chain(&html))?;
    let pipeline = pipeline::load("gi")?;
    let suite = Suite {
        settings: Settings {
            registry,
            pipeline: &pipeline,
            formats: args.formats.clone(),
            encodings: args.encodings.clone(),
            tracers: args.tracers.clone(),
            resolutions: args.resolutions.clone(),
            scales: Vec::new(),
            size: args.size,
            adapter: args.adapter.clone(),
        },
        cases: args.cases.clone(),
    };
    let mut progress = Progress::new();
    let Ran { stability, finished, all } = suite.run(&mut progress, stop)?;
    drop(progress);
    let mut files = Vec::new();
    if let Some(file) = json {
        let text = stability.to_json().map_err(|error| Failure::work(error.to_string()))?;
        files.push((file, text.into_bytes()));
    }
    if let Some(file) = html {
        files.push((file, stability_page(&stability, &utc_now()).into_bytes()));
    }
    crate::print(&table(&stability))?;
    outfile::write(&files)?;
    let failed = stability.rows.iter().filter(|row| row.verdict() == "FAIL").count();
    match (finished == all, failed) {
        (false, _) => Err(Error::Interrupted { finished, all }.into()),
        (true, 0) => Ok(()),
        (true, _) => Err(Failure::work(format!(
            "{failed} of {} figures are out of their bounds",
            stability.rows.len()
        ))),
    }
}

fn list() -> Result<(), Failure> {
    let mut table = Table::new(["case", "what should hold", "scene"]);
    for case in cases() {
        table.row([case.name.into(), case.property.into(), case.scene.0.into()]);
    }
    crate::print(&table.to_string())
}

fn table(stability: &Stability) -> String {
    let mut table =
        Table::new(["case", "format", "encoding", "tracer", "figure", "N", "value", "bound", "verdict"])
            .numbers_from(5);
    for row in &stability.rows {
        let number = |value: f64| format!("{value:.3e}");
        table.row([
            row.case.clone(),
            row.format.clone(),
            row.encoding.clone(),
            row.tracer.clone(),
            row.figure.clone(),
            row.resolution.to_string(),
            number(row.value),
            row.bound.map_or_else(|| "-".into(), number),
            row.verdict().into(),
        ]);
    }
    table.to_string()
}
