//! Pipelines by name or file.

use std::path::Path;

use voxlume::{Fault, Faults, Pipeline};

/// The built-in pipeline of that name, or the one in a `.ron` file.
pub fn load(name: &str) -> Result<Pipeline, Faults> {
    let path = Path::new(name);
    if path.extension().is_some_and(|extension| extension == "ron") {
        return Pipeline::load(path);
    }
    let or_file = |fault: Fault| fault.note("or a file, whose name ends in `.ron`");
    Pipeline::builtin(name).map_err(|faults| faults.map(or_file))
}
