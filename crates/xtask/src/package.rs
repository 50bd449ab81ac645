//! The crates as others would get them.

use std::fs;
use std::io;
use std::path::Path;
use std::process::Command;

use crate::{cargo, root, run};

/// Crates that stay in the repository: they test, measure, show and set up.
const KEPT: [&str; 4] = ["voxlume-sh3", "voxlume-xtask", "voxlume-tests", "voxlume-benches"];

/// Packs every crate that others may depend on, unpacks them side by side, and checks that they compile there.
///
/// Cargo's own verification keeps what it once unpacked of a version, so that a second run would see old files.
pub fn package() -> Result<(), String> {
    let target = root().join("target/packages");
    let packages = target.join("package");
    if packages.exists() {
        fs::remove_dir_all(&packages).map_err(|error| at(&packages, &error))?;
    }
    let mut pack = cargo();
    pack.args(["package", "--workspace", "--no-verify", "--allow-dirty", "--quiet", "--target-dir"]);
    run(pack.arg(&target).args(KEPT.iter().flat_map(|name| ["--exclude", name])))?;

    let mut manifest =
        String::from("[workspace]\nresolver = \"3\"\nmembers = [\"*-*.*.*\"]\n\n[patch.crates-io]\n");
    for entry in fs::read_dir(&packages).map_err(|error| at(&packages, &error))? {
        let file = entry.map_err(|error| at(&packages, &error))?.file_name().to_string_lossy().into_owned();
        let Some(folder) = file.strip_suffix(".crate") else { continue };
        let Some((name, _version)) = folder.rsplit_once('-') else { continue };
        // The archive's files are all of one date, by which Cargo would take changed ones for those that it compiled.
        run(Command::new("tar").args(["-xzmf", &file]).current_dir(&packages))?;
        manifest += &format!("{name} = {{ path = \"{folder}\" }}\n");
    }
    let file = packages.join("Cargo.toml");
    fs::write(&file, manifest).map_err(|error| at(&file, &error))?;
    // The versions of what they depend on, as they are tested.
    let lock = packages.join("Cargo.lock");
    fs::copy(root().join("Cargo.lock"), &lock).map_err(|error| at(&lock, &error))?;
    let mut check = cargo();
    run(check.args(["check", "--workspace", "--manifest-path"]).arg(&file).arg("--target-dir").arg(&target))
}

fn at(path: &Path, error: &io::Error) -> String {
    format!("`{}`: {error}", path.display())
}
