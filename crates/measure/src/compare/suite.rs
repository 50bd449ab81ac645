//! The suite: scenes that anyone can have, and how near each effect has to come to the reference in them, at 128³ and
//! 256×144 pixels.

use std::path::{Path, PathBuf};

use voxlume::Fault;
use voxlume_report::Bound;

use crate::Error;

/// Its scenes, as files of a folder.
pub const SCENES: [&str; 5] =
    ["cornell.glb", "cornell_double_sided.glb", "cornell_blender.glb", "sponza_lite.glb", "sibenik.glb"];

/// For each effect and the scenes in their order: |bias| over the mean, in per cent, RMSE and FLIP; 0 where none is stated.
const BOUNDS: [(&str, [[f64; 3]; 5]); 5] = [
    (
        "soft_shadow",
        [[2.0, 0.045, 0.0], [2.0, 0.045, 0.0], [3.0, 0.06, 0.0], [3.0, 0.08, 0.0], [2.0, 0.08, 0.0]],
    ),
    (
        "ambient_occlusion",
        [[2.0, 0.035, 0.0], [2.0, 0.035, 0.0], [2.0, 0.035, 0.0], [6.0, 0.07, 0.0], [5.0, 0.07, 0.0]],
    ),
    ("diffuse", [[2.0, 0.022, 0.0], [2.0, 0.022, 0.0], [4.0, 0.04, 0.0], [5.0, 0.06, 0.0], [3.0, 0.08, 0.0]]),
    ("specular", [[5.0, 0.0, 0.0], [5.0, 0.0, 0.0], [8.0, 0.0, 0.0], [15.0, 0.04, 0.0], [8.0, 0.05, 0.0]]),
    (
        "final",
        [[0.5, 0.007, 0.0], [0.5, 0.007, 0.0], [2.0, 0.02, 0.0], [2.0, 0.025, 0.08], [1.5, 0.035, 0.09]],
    ),
];

/// The suite's scene files in a folder.
///
/// # Errors
/// A file that isn't there.
pub fn scenes(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let files: Vec<PathBuf> = SCENES.iter().map(|name| folder.join(name)).collect();
    match files.iter().find(|file| !file.is_file()) {
        Some(missing) => Err(Fault::new(format!(
            "the suite lacks `{}`; it needs {} in one folder",
            missing.display(),
            SCENES.join(", ")
        ))
        .into()),
        None => Ok(files),
    }
}

/// The bounds.
pub fn bounds() -> Vec<Bound> {
    let stated = |value: f64| (value > 0.0).then_some(value);
    let of_effect = |(effect, list): &(&str, [[f64; 3]; 5])| {
        let bounds = SCENES.iter().zip(list).map(|(scene, [bias, rmse, flip])| Bound {
            scene: scene.trim_end_matches(".glb").to_owned(),
            effect: (*effect).to_owned(),
            bias: bias / 100.0,
            rmse: stated(*rmse),
            flip: stated(*flip),
        });
        bounds.collect::<Vec<_>>()
    };
    BOUNDS.iter().flat_map(of_effect).collect()
}
