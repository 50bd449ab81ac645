//! Files that appear whole or not at all.

use std::collections::HashSet;
use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use voxlume::Fault;

use crate::Error;

/// A file to be written.
#[derive(Debug)]
pub struct OutFile {
    path: PathBuf,
    temporary: PathBuf,
}

impl OutFile {
    /// Finds out, before the long work, whether the file can be written; nothing is left behind.
    ///
    /// # Errors
    /// Its folder is missing or can't be written to, or there is something of its name that is no file.
    pub fn new(path: &Path) -> Result<OutFile, Fault> {
        let cannot = |why: &str| Fault::new(format!("cannot write `{}`: {why}", path.display()));
        // A link is written through.
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
        if target.exists() && !target.is_file() {
            return Err(cannot("there is something else of that name"));
        }
        let name = target.file_name().ok_or_else(|| cannot("no file name"))?.to_string_lossy();
        let temporary = target.with_file_name(format!(".{name}.{}.tmp", std::process::id()));
        let probe = File::create_new(&temporary).and_then(|_| fs::remove_file(&temporary));
        match probe {
            Ok(()) => Ok(OutFile { path: target, temporary }),
            Err(error) => Err(cannot(&match error.kind() {
                ErrorKind::NotFound => "its folder does not exist or takes no files".to_owned(),
                ErrorKind::NotADirectory => "its folder is a file".to_owned(),
                _ => error.to_string(),
            })),
        }
    }
}

/// Finds out, before the long work, whether two of the files are the same.
pub fn distinct<'f>(files: impl IntoIterator<Item = &'f OutFile>) -> Result<(), Fault> {
    let mut known = HashSet::new();
    for OutFile { path, .. } in files {
        if !known.insert(std::path::absolute(path).unwrap_or_else(|_| path.clone())) {
            return Err(Fault::new(format!("`{}` is to be written twice", path.display())));
        }
    }
    Ok(())
}

/// Writes all the files, or none: each under another name in its folder first, then all are renamed.
pub fn write(files: &[(OutFile, Vec<u8>)]) -> Result<(), Error> {
    let written = files.iter().try_for_each(|(file, bytes)| {
        let store = || {
            let mut open = File::create_new(&file.temporary)?;
            open.write_all(bytes)?;
            open.sync_all()
        };
        store().map_err(|error| (file, error))
    });
    let renamed = written.and_then(|()| {
        files
            .iter()
            .try_for_each(|(file, _)| fs::rename(&file.temporary, &file.path).map_err(|error| (file, error)))
    });
    renamed.map_err(|(file, error)| {
        for (file, _) in files {
            // What was renamed is gone already.
            let _ = fs::remove_file(&file.temporary);
        }
        Error::work(format!("cannot write `{}`: {error}", file.path.display()))
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn all_or_none() {
        let folder = tempfile::tempdir().unwrap();
        let files = |last: &str| {
            let path = |name: &str| OutFile::new(&folder.path().join(name)).unwrap();
            vec![(path("a"), b"first".to_vec()), (path(last), b"second".to_vec())]
        };
        let mut lost = files("b");
        lost[1].0.temporary = folder.path().join("nowhere/b");
        assert!(write(&lost).is_err());
        assert!(names(folder.path()).is_empty());

        write(&files("b")).unwrap();
        assert_eq!(names(folder.path()), ["a", "b"]);
        assert_eq!(fs::read(folder.path().join("b")).unwrap(), b"second");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_written_through() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("real"), "old").unwrap();
        std::os::unix::fs::symlink("real", folder.path().join("link")).unwrap();
        write(&[(OutFile::new(&folder.path().join("link")).unwrap(), b"new".to_vec())]).unwrap();
        assert_eq!(fs::read(folder.path().join("real")).unwrap(), b"new");
        assert!(folder.path().join("link").is_symlink());
    }
}
