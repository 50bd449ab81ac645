//! The crates as they would be published.

use crate::{cargo, root, run};

/// Crates that stay in the repository: they test, measure, show and set up.
const KEPT: [&str; 4] = ["voxlume-sh3", "voxlume-xtask", "voxlume-tests", "voxlume-benches"];

/// Packs every crate that others may depend on, and builds each from what was packed.
pub fn package() -> Result<(), String> {
    let mut command = cargo();
    command.args(["package", "--workspace", "--allow-dirty", "--quiet"]);
    command.args(KEPT.iter().flat_map(|name| ["--exclude", name]));
    // Else Cargo would build the dependencies anew for each crate.
    command.env("CARGO_TARGET_DIR", root().join("target/packages"));
    run(&mut command)
}
