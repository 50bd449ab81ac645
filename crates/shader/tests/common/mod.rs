//! Libraries in memory.

use voxlume_fault::Source;
use voxlume_shader::Library;

/// A library of modules, each named after the file `<path>.wgsl`.
pub fn library(modules: &[(&str, &str)]) -> Library {
    let mut library = Library::empty();
    for (path, text) in modules {
        library.insert(path, Source::new(format!("{path}.wgsl"), *text));
    }
    library
}
