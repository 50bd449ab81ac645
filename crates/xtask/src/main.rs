//! Set-up of a bare machine: `cargo xtask render` and `cargo xtask test` build what they need, see to it that
//! there is a graphics device, and do the work. `cargo xtask package` tries the crates as others would get them.

mod driver;
mod package;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

const USAGE: &str = "cargo xtask render    build everything and render the Cornell box to out/cornell.png
cargo xtask test      build everything and run all tests
cargo xtask package   pack every crate that others may depend on, and compile them from their packages

Where no graphics device is found, the first two install Debian's software Vulkan driver if they may (as root or with a
sudo that asks for no password), and say in one line what to install otherwise.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["render"] => render(),
        ["test"] => test(),
        ["package"] => package::package(),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn render() -> Result<(), String> {
    driver::ensure(&["--release"])?;
    let folder = root().join("out");
    std::fs::create_dir_all(&folder).map_err(|error| format!("`{}`: {error}", folder.display()))?;
    let program = ["run", "--quiet", "--release", "--package", "voxlume-cli", "--"];
    run(cargo().args(program).args(["render", "scenes/cornell.ron", "-o", "out/cornell.png"]))
}

fn test() -> Result<(), String> {
    driver::ensure(&[])?;
    run(cargo().args(["test", "--workspace"]))
}

/// The workspace's folder.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Cargo, at the root of the workspace.
fn cargo() -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root());
    command
}

/// Runs a command to its end; what it prints is seen.
fn run(command: &mut Command) -> Result<(), String> {
    let name = format!("{} {}", command.get_program().display(), arguments(command));
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("`{name}`: {status}")),
        Err(error) => Err(format!("`{name}`: {error}")),
    }
}

fn arguments(command: &Command) -> String {
    let words: Vec<_> = command.get_args().map(|word| word.to_string_lossy()).collect();
    words.join(" ")
}
