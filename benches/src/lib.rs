//! What benches share; what is measured is in `benches`, see the README.

mod stages;
pub mod table;
pub mod tube;

use std::io;
use std::path::{Path, PathBuf};

pub use stages::Stages;

/// Makes the repository the folder that paths start from.
///
/// # Errors
/// It is gone.
pub fn enter_repository() -> io::Result<()> {
    std::env::set_current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
}

/// A scene in the folder of scenes beside the repository, which may not be there; from the repository.
pub fn shared_scene(name: &str) -> PathBuf {
    Path::new("../shared/scenes").join(name).with_extension("glb")
}

/// Removes a folder if it is there.
///
/// # Errors
/// It can't be removed.
pub fn remove_folder(folder: &Path) -> io::Result<()> {
    match std::fs::remove_dir_all(folder) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}
