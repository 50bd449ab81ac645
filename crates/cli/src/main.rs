//! The program `voxlume`; see the library beside it.

use std::process::ExitCode;

use voxlume_cli::{Registry, main_with};

fn main() -> ExitCode {
    main_with(&Registry::builtin(), std::env::args_os())
}
