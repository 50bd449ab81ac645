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
    let mounts = [
        "format", "encoding", "filter", "tracer", "walk", "meet", "lamps", "emitters", "seen", "effect",
        "visitor",
    ]
    .map(|name| (name, in_folder(name, 2)));
    assert!(mounts.iter().all(|(_, folders)| !folders.is_empty()));
    let targets =
        mounts.each_ref().map(|(_, folders)| folders.iter().map(String::as_str).collect::<Vec<_>>());
    let mut alternatives: Vec<_> =
        mounts.iter().zip(&targets).map(|((name, _), of)| (*name, of.as_slice())).collect();
    alternatives.push(("level_walk", &["walk/bricks"]));
    // The others differ in the texture alone, and are checked by themselves.
    alternatives.push(("texel", &["texel/rgba16float"]));
    let faults = check_all(&library, &alternatives);
    assert!(faults.is_empty(), "\n{faults}");
}
