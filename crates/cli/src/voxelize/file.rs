//! What voxels are written as.

use std::path::Path;

use voxlume::{Fault, one_of};

use voxlume_measure::picture;

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// As a camera sees them.
    Picture(picture::Kind),
    /// As points.
    Ply,
    /// As a model of MagicaVoxel's.
    Vox,
}

impl Kind {
    /// By the path's extension.
    pub fn of(path: &Path) -> Result<Kind, Fault> {
        match path.extension().unwrap_or_default().to_string_lossy().to_lowercase().as_str() {
            "ply" => Ok(Kind::Ply),
            "vox" => Ok(Kind::Vox),
            _ => picture::Kind::of(path).map(Kind::Picture).map_err(|_| {
                let message = format!("`{}` is no file of voxels by its extension", path.display());
                Fault::new(message).note(one_of(["png", "exr", "ply", "vox"]))
            }),
        }
    }

    /// Whether a camera sees it.
    pub fn is_picture(self) -> bool {
        matches!(self, Kind::Picture(_))
    }
}
