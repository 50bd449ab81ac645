//! The program `voxlume`: renders scenes, shows their voxels, compares them with a path tracer, explains and checks pipelines, lists devices.
//!
//! [`main_with`] runs it with storage formats of your own: they appear in every command beside the built-in ones.

mod args;
mod check;
mod compare;
mod devices;
mod explain;
mod failure;
mod interrupt;
mod library;
mod pipeline;
mod progress;
mod reference;
mod render;
mod stability;
mod table;
mod timing;
mod voxelize;

use std::ffi::OsString;
use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use tracing_subscriber::EnvFilter;
use tracing_subscriber::filter::LevelFilter;

pub use voxlume::Registry;

use crate::failure::Failure;

/// Voxel cone tracing with storage formats that one word swaps.
#[derive(Parser)]
#[command(name = "voxlume", version, max_term_width = 100, after_help = EXAMPLES)]
struct Program {
    #[command(subcommand)]
    command: Command,

    /// Folder laid out as Voxlume's own `wgsl`, whose modules take the place of the built-in ones: to change shaders
    /// without building anything
    #[arg(long, value_name = "FOLDER", global = true)]
    wgsl: Option<PathBuf>,
}

const EXAMPLES: &str = "Examples:
  voxlume render scenes/cornell.ron -o cornell.png
  voxlume render scenes/cornell.ron --format sh2 --resolution 64 --repeat 20 -o sh2.png --json sh2.json
  voxlume voxelize scenes/cornell.ron --resolution 64 -o voxels.png -o voxels.ply
  voxlume compare scenes/cornell.ron --resolutions 32,64 --out cornell
  voxlume explain scenes/cornell.ron
  voxlume check pipelines/gi.ron my_effect.wgsl

Exit codes: 0 done, 1 the work failed, 2 bad input or usage. RUST_LOG=info shows what goes on inside.";

#[derive(Subcommand)]
enum Command {
    Render(render::Args),
    Voxelize(voxelize::Args),
    Compare(compare::Args),
    Reference(reference::Args),
    Explain(explain::Args),
    Check(check::Args),
    Stability(stability::Args),
    Devices(devices::Args),
}

/// Carries out the command that `arguments` say, the program's name first, and tells what went wrong on stderr.
/// Called once, at the start of `main`, before there are other threads.
pub fn main_with(registry: &Registry, arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    quieten_vulkan();
    let program = Program::parse_from(arguments);
    let filter = EnvFilter::builder().with_default_directive(LevelFilter::WARN.into()).from_env_lossy();
    let colour = std::io::stderr().is_terminal();
    tracing_subscriber::fmt().with_env_filter(filter).with_writer(std::io::stderr).with_ansi(colour).init();

    match run(&program, registry) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // Nobody is left to tell where stderr is closed.
            let _ = writeln!(std::io::stderr(), "{failure}");
            failure.exit_code()
        }
    }
}

fn run(program: &Program, registry: &Registry) -> Result<(), Failure> {
    let changed;
    let registry = match &program.wgsl {
        Some(folder) => {
            let library = library::with_folder(&registry.library, folder)?;
            changed = Registry { library, ..registry.clone() };
            &changed
        }
        None => registry,
    };
    match &program.command {
        Command::Render(args) => render::run(args, registry),
        Command::Voxelize(args) => voxelize::run(args, registry),
        Command::Compare(args) => compare::run(args, registry),
        Command::Reference(args) => reference::run(args, registry),
        Command::Explain(args) => explain::run(args, registry),
        Command::Check(args) => check::run(args, registry),
        Command::Stability(args) => stability::run(args, registry),
        Command::Devices(args) => devices::run(args),
    }
}

/// Without a desktop session, Mesa's device-select layer, which nobody needs then, has libwayland complain on stderr
/// each time that devices are asked for.
fn quieten_vulkan() {
    if cfg!(target_os = "linux") && std::env::var_os("XDG_RUNTIME_DIR").is_none() {
        // SAFETY: no other thread exists yet.
        #[expect(unsafe_code, reason = "the layer is told by the environment only")]
        unsafe {
            std::env::set_var("NODEVICE_SELECT", "1");
        }
    }
}

/// Prints to stdout. A reader that has seen enough, such as `head`, is no failure.
fn print(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::work(format!("cannot write to the standard output: {error}")))
        }
        _ => Ok(()),
    }
}
