//! WGSL from a folder in the place of built-in modules.

use std::path::{Path, PathBuf};

use voxlume::{Fault, Faults, Library, Source};

/// The library with every `.wgsl` file below `folder`, laid out as Voxlume's own folder `wgsl` is: `common/grid.wgsl` takes
/// the place of the module `common/grid`, and what has no module's place is added.
///
/// # Errors
/// A folder or file that can't be read; no such file in it.
pub fn with_folder(library: &Library, folder: &Path) -> Result<Library, Faults> {
    let mut library = library.clone();
    let mut files = Vec::new();
    find(folder, &mut files)?;
    if files.is_empty() {
        return Err(Fault::new(format!("no .wgsl file in `{}`", folder.display())).into());
    }
    for path in files {
        let source = Source::read(&path)?;
        let place = path.strip_prefix(folder).unwrap_or(&path).with_extension("");
        let names: Vec<_> = place.components().map(|part| part.as_os_str().to_string_lossy()).collect();
        library.insert(&names.join("/"), source);
    }
    Ok(library)
}

/// Gathers files, sorted; links to folders are not followed, as they may lead back.
fn find(folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), Fault> {
    let unreadable =
        |error: std::io::Error| Fault::new(format!("cannot read `{}`: {error}", folder.display()));
    let entries: Vec<_> =
        std::fs::read_dir(folder).map_err(unreadable)?.collect::<Result<_, _>>().map_err(unreadable)?;
    let mut paths: Vec<_> = entries.iter().map(|entry| (entry.path(), entry.file_type())).collect();
    paths.sort_by(|(a, _), (b, _)| a.cmp(b));
    for (path, kind) in paths {
        if kind.map_err(unreadable)?.is_dir() {
            find(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "wgsl") {
            files.push(path);
        }
    }
    Ok(())
}
