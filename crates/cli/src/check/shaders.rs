//! WGSL files among the built-in modules.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use voxlume::{Faults, Registry, Source, check_all};

/// Checks all built-in modules with these files in their places.
pub fn check(files: &[(PathBuf, Arc<Source>)], registry: &Registry) -> Faults {
    let mut faults = Faults::default();
    // Files that would take the same place are checked one after the other.
    let mut rounds = vec![(registry.library.clone(), BTreeSet::new())];
    for (path, source) in files {
        let module = module_path(path);
        let free = rounds.iter().position(|(_, taken)| !taken.contains(&module)).unwrap_or(rounds.len());
        if free == rounds.len() {
            rounds.push((registry.library.clone(), BTreeSet::new()));
        }
        rounds[free].0.insert(&module, Arc::clone(source));
        rounds[free].1.insert(module);
    }
    let formats: Vec<&str> = registry.formats.iter().map(|format| format.modules()).collect();
    let tracers: Vec<&str> = registry.tracers.iter().map(|tracer| tracer.modules).collect();
    let encodings: Vec<&str> = registry.encodings.iter().map(|encoding| encoding.module).collect();
    for (library, _) in &rounds {
        let folder = |name: &str| library.paths().filter(|path| path.starts_with(name)).collect::<Vec<_>>();
        let [effects, visitors, filters, walks, meets, lamps, emitters, seen] =
            ["effect/", "visitor/", "filter/", "walk/", "meet/", "lamps/", "emitters/", "seen/"].map(folder);
        let alternatives = [
            ("format", &formats[..]),
            ("encoding", &encodings),
            ("filter", &filters),
            ("tracer", &tracers),
            ("walk", &walks),
            // Columns have no levels.
            ("level_walk", &["walk/bricks"]),
            ("meet", &meets),
            ("lamps", &lamps),
            ("emitters", &emitters),
            ("seen", &seen),
            ("effect", &effects),
            ("visitor", &visitors),
            // The others differ in the texture alone, and are checked by themselves.
            ("texel", &["texel/rgba16float"]),
        ];
        faults.extend(check_all(library, &alternatives));
    }
    faults
}

/// The place below a folder `wgsl`, or that of an effect.
fn module_path(path: &Path) -> String {
    let path = path.with_extension("");
    let parts: Vec<String> = path
        .components()
        .filter_map(|part| match part {
            Component::Normal(name) => Some(name.to_string_lossy().into_owned()),
            _ => None,
        })
        .collect();
    match parts.iter().rposition(|part| part == "wgsl") {
        Some(at) if at + 1 < parts.len() => parts[at + 1..].join("/"),
        _ => format!("effect/{}", parts.last().map(String::as_str).unwrap_or_default()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_of_files() {
        assert_eq!(module_path(Path::new("wgsl/common/grid.wgsl")), "common/grid");
        assert_eq!(module_path(Path::new("/a/wgsl/format/sh2/store.wgsl")), "format/sh2/store");
        assert_eq!(module_path(Path::new("pipelines/glow.wgsl")), "effect/glow");
        assert_eq!(module_path(Path::new("./wgsl.wgsl")), "effect/wgsl");
    }
}
