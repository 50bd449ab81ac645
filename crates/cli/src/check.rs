//! `voxlume check`.

mod files;
mod pipelines;
mod shaders;

use std::collections::BTreeSet;
use std::path::PathBuf;

use voxlume::{Faults, PIPELINES, Pipeline, Scene, Source};

use self::files::Files;
use crate::Registry;
use crate::failure::Failure;

/// Check pipelines, scenes and WGSL; every fault with its file, line and column
///
/// Needs no GPU. A pipeline is planned with every storage format and tracer for scenes that need all of it, and its own
/// effects are checked with it. A .wgsl file in a folder `wgsl` takes the place of the built-in module below that
/// folder; any other is checked as an effect. Exit code 2 if anything is wrong.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume check
  voxlume check pipelines/gi.ron scenes/cornell.ron
  voxlume check my_pipeline/        everything in the folder")]
pub struct Args {
    /// Files or folders: .ron, .gltf, .glb, .wgsl. Without any: all built-in WGSL and pipelines, and what is in
    /// ./pipelines and ./scenes
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    let mut faults = Faults::default();
    let everything = args.files.is_empty();
    let mut files = if everything {
        let usual = ["pipelines", "scenes"].map(PathBuf::from);
        Files::find(&usual.into_iter().filter(|folder| folder.is_dir()).collect::<Vec<_>>(), &mut faults)
    } else {
        Files::find(&args.files, &mut faults)
    };
    if everything {
        files.pipelines.extend(PIPELINES.iter().map(|(_, file, text)| Source::new(*file, *text)));
    }

    if everything || !files.shaders.is_empty() {
        faults.extend(shaders::check(&files.shaders, registry));
    }
    for source in &files.pipelines {
        if let Some(pipeline) = faults.gather(Pipeline::parse(source)) {
            faults.extend(pipelines::check(&pipeline, registry));
        }
    }
    for path in &files.scenes {
        faults.gather(Scene::load(path));
    }

    // A pipeline's fault comes once for every plan that has it.
    let mut told = BTreeSet::new();
    let mut different = Faults::default();
    different.extend(faults.into_iter().filter(|fault| told.insert(fault.to_string())));
    let modules = if everything { registry.library.paths().count() } else { 0 } + files.shaders.len();
    let checked =
        [(files.pipelines.len(), "pipeline"), (files.scenes.len(), "scene"), (modules, "WGSL module")];
    let checked: Vec<String> =
        checked.iter().filter(|(n, _)| *n > 0).map(|(n, what)| count(*n, what)).collect();
    let told = match told.len() {
        0 => "no faults".to_owned(),
        n => count(n, "fault"),
    };
    let summary = if checked.is_empty() { told } else { format!("{}: {told}", checked.join(", ")) };
    if different.is_empty() {
        crate::print(&(summary + "\n"))
    } else {
        Err(Failure::Checked(different, summary))
    }
}

fn count(n: usize, what: &str) -> String {
    if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") }
}
