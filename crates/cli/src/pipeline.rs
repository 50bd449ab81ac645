//! Pipelines by name or file.

use std::path::Path;

use voxlume::{Faults, Pipeline};

/// The built-in pipeline of that name, or the one in a `.ron` file.
pub fn load(name: &str) -> Result<Pipeline, Faults> {
    let path = Path::new(name);
    if path.extension().is_some_and(|extension| extension == "ron") {
        return Pipeline::load(path);
    }
    Pipeline::builtin(name).map_err(|faults| {
        let mut noted = Faults::default();
        noted.extend(faults.into_iter().map(|fault| fault.note("or a file, whose name ends in `.ron`")));
        noted
    })
}
