//! `voxlume explain`.

use crate::Registry;
use crate::args::ImageArgs;
use crate::failure::Failure;

/// Print the plan: passes in order, resources and their bytes, and what was left out and why
///
/// Needs no GPU.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  voxlume explain scenes/cornell.ron
  voxlume explain scenes/cornell.ron --format six_face --resolution 256
  voxlume explain scenes/cornell.ron --output ao")]
pub struct Args {
    #[command(flatten)]
    image: ImageArgs,
}

/// Runs the command.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    let pipeline = args.image.plan.pipeline()?;
    let scene = args.image.plan.scene()?;
    let plan = args.image.plan(registry, &pipeline, &scene, None)?;
    crate::print(&voxlume::explain(&plan))
}
