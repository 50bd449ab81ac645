//! Files sorted by what they hold.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use voxlume::{Fault, Faults, Source, one_of};
use voxlume_fault::ron::Document;

/// Extensions of what can be checked.
const EXTENSIONS: [&str; 4] = ["ron", "gltf", "glb", "wgsl"];

/// What there is to check.
#[derive(Debug, Default)]
pub struct Files {
    /// RON that describes passes.
    pub pipelines: Vec<Arc<Source>>,
    /// Any other RON, and glTF.
    pub scenes: Vec<PathBuf>,
    /// WGSL with its path.
    pub shaders: Vec<(PathBuf, Arc<Source>)>,
}

impl Files {
    /// Sorts files, and of folders those directly inside that can be checked.
    pub fn find(paths: &[PathBuf], faults: &mut Faults) -> Files {
        let mut files = Files::default();
        for path in paths {
            if path.is_dir() {
                let inside = faults.gather(inside(path)).unwrap_or_default();
                inside.iter().for_each(|path| _ = faults.gather(files.add(path)));
            } else {
                faults.gather(files.add(path));
            }
        }
        files
    }

    fn add(&mut self, path: &Path) -> Result<(), Fault> {
        match extension(path).as_str() {
            "gltf" | "glb" => self.scenes.push(path.to_path_buf()),
            "wgsl" => self.shaders.push((path.to_path_buf(), Source::read(path)?)),
            "ron" => {
                let source = Source::read(path)?;
                match describes_passes(&source)? {
                    true => self.pipelines.push(source),
                    false => self.scenes.push(path.to_path_buf()),
                }
            }
            _ => {
                let fault = Fault::new(format!("`{}` is nothing to check by its extension", path.display()));
                return Err(fault.note(one_of(EXTENSIONS)));
            }
        }
        Ok(())
    }
}

fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}

fn inside(folder: &Path) -> Result<Vec<PathBuf>, Fault> {
    let read = || std::fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect();
    let all: std::io::Result<Vec<PathBuf>> = read();
    let all = all.map_err(|error| Fault::new(format!("cannot read `{}`: {error}", folder.display())))?;
    let mut files: Vec<PathBuf> = all
        .into_iter()
        .filter(|path| path.is_file() && EXTENSIONS.contains(&extension(path).as_str()))
        .collect();
    files.sort();
    Ok(files)
}

/// A pipeline has passes and a format; a scene has neither.
fn describes_passes(source: &Arc<Source>) -> Result<bool, Fault> {
    let document = Document::parse(source)?;
    let fields = document.root().fields().unwrap_or_default();
    Ok(fields.iter().any(|field| ["passes", "format"].contains(&field.name)))
}
