//! Tables every module of the repository's `wgsl` folder as `(module path, text)`.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    // Asked now and not when this was compiled: another checkout may share the folder of built files.
    let manifest = env::var_os("CARGO_MANIFEST_DIR").ok_or_else(|| io::Error::other("cargo sets it"))?;
    let root = Path::new(&manifest).join("wgsl").canonicalize()?;
    // Cargo looks at every file below a folder that is named here.
    println!("cargo::rerun-if-changed={}", root.display());
    let mut files = Vec::new();
    find(&root, &mut files)?;
    files.sort();

    let mut table = String::from("[\n");
    for file in files {
        let stem = file.strip_prefix(&root).map_err(io::Error::other)?.with_extension("");
        let module: Vec<_> = stem.iter().map(|part| part.to_string_lossy()).collect();
        writeln!(table, "({:?}, include_str!({file:?})),", module.join("/")).map_err(io::Error::other)?;
    }
    table.push(']');
    let out = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("cargo sets OUT_DIR"))?;
    fs::write(Path::new(&out).join("builtin.rs"), table)
}

fn find(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            find(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "wgsl") {
            files.push(path);
        }
    }
    Ok(())
}
