//! `voxlume stability`.

mod bench;
mod cases;
mod figure;
mod misses;
mod sweep;

use std::path::PathBuf;

use crate::Registry;
use crate::args::size;
use crate::failure::Failure;

/// Run hard cases: numerical stability as figures with bounds
///
/// Each case is a small scene that breaks renderers, with a property that should hold; a figure says how far it does. Ends with
/// exit code 1 if a figure is out of its bound and that is not a known miss. The book's page on stability says what each
/// case measures, and why some can't hold.
///
/// --json writes {"schema": 1, "device": {…}, "rows": [{"case", "format", "encoding", "resolution", "figure", "value", "bound", "pass"}]};
/// a bound of null means that the figure is only measured.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume stability --list
  voxlume stability --json stability.json --html stability.html
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
    if args.list { sweep::list() } else { sweep::run(args, registry) }
}
