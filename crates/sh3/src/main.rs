//! All of Voxlume's commands, with `sh3` among the formats.

use std::process::ExitCode;

// ANCHOR: main
fn main() -> ExitCode {
    let mut registry = voxlume_cli::Registry::builtin();
    voxlume_sh3::register(&mut registry.formats, &mut registry.library);
    voxlume_cli::main_with(&registry, std::env::args_os())
}
// ANCHOR_END: main
