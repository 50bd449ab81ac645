//! Every module that comes with Voxlume is valid, with every format and effect.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::BTreeSet;

use voxlume_shader::{Library, check_all};

#[test]
fn every_builtin_module_is_valid() {
    let library = Library::builtin();
    let in_folder = |folder: &str, depth: usize| {
        let paths = library.paths().filter(|path| path.split('/').next() == Some(folder));
        paths.map(|path| path.split('/').take(depth).collect::<Vec<_>>().join("/")).collect::<BTreeSet<_>>()
    };
    let [formats, encodings, effects, visitors] =
        ["format", "encoding", "effect", "visitor"].map(|folder| in_folder(folder, 2));
    assert!(!formats.is_empty() && !effects.is_empty() && !visitors.is_empty());
    let formats: Vec<&str> = formats.iter().map(String::as_str).collect();
    let effects: Vec<&str> = effects.iter().map(String::as_str).collect();
    let encodings: Vec<&str> = encodings.iter().map(String::as_str).collect();

    let visitors: Vec<&str> = visitors.iter().map(String::as_str).collect();

    let alternatives = [
        ("format", &formats[..]),
        ("encoding", &encodings),
        ("effect", &effects),
        ("visitor", &visitors),
        ("texel", &["texel/rgba16float"]),
    ];
    let faults = check_all(&library, &alternatives);
    assert!(faults.is_empty(), "\n{faults}");
}
