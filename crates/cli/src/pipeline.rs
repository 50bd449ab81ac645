//! Pipelines by name or file.

use std::path::Path;

use voxlume::{Fault, Faults, Pipeline, Source};
use voxlume_fault::suggest;

/// Pipelines that the program carries: name, file, text.
pub const BUILTIN: [(&str, &str, &str); 2] = [
    ("gi", "pipelines/gi.ron", include_str!("../../../pipelines/gi.ron")),
    ("rauwendaal", "pipelines/rauwendaal.ron", include_str!("../../../pipelines/rauwendaal.ron")),
];

/// The built-in pipeline of that name, or the one in a `.ron` file.
pub fn load(name: &str) -> Result<Pipeline, Faults> {
    if let Some((_, file, text)) = BUILTIN.iter().find(|(builtin, ..)| *builtin == name) {
        return Pipeline::parse(&Source::new(*file, *text));
    }
    let path = Path::new(name);
    if path.extension().is_none_or(|extension| extension != "ron") {
        let label = suggest(name, BUILTIN.iter().map(|(builtin, ..)| *builtin));
        return Err(Fault::new(format!("unknown pipeline `{name}`"))
            .note(format!("{label}, or a .ron file"))
            .into());
    }
    Pipeline::load(path)
}
