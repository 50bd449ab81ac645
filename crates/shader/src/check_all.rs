//! Every module of a library checked, in every way that it can be linked.

use std::collections::BTreeSet;
use std::sync::Arc;

use voxlume_fault::Faults;

use crate::contract::Contract;
use crate::library::Library;
use crate::link::link;
use crate::module::Module;
use crate::mount::{Mounts, below};

/// Links and checks every module by itself, holds it against its [`Contract`] if its path has one, and gives
/// each fault once. An alternative `(name, targets)` is a mount with each of its targets in turn, such as
/// `("format", &["format/isotropic", "format/sh2"])`, tried where a module, or what it imports, needs it; a
/// module below one of the targets is checked with that one only.
pub fn check_all(library: &Library, alternatives: &[(&str, &[&str])]) -> Faults {
    let mut told = BTreeSet::new();
    let mut faults = Faults::default();
    for path in library.paths() {
        for mounts in combinations(library, path, alternatives, Vec::new()) {
            let found = check(library, path, &mounts).err().unwrap_or_default();
            faults.extend(found.into_iter().filter(|fault| told.insert(fault.to_string())));
        }
    }
    faults
}

fn check(library: &Library, path: &str, mounts: &[(&str, &str)]) -> Result<(), Faults> {
    let shader = link(library, path, mounts)?.check()?;
    Contract::of(path).map_or(Ok(()), |contract| shader.fulfils(contract, path))
}

/// The mounts to link a module with: those `chosen`, with every target of each further one that is needed.
fn combinations<'a>(
    library: &Library,
    path: &str,
    alternatives: &[(&'a str, &[&'a str])],
    chosen: Vec<(&'a str, &'a str)>,
) -> Vec<Vec<(&'a str, &'a str)>> {
    let mounts = Mounts::new(&chosen);
    let open = alternatives.iter().filter(|(name, _)| !chosen.iter().any(|(taken, _)| taken == name));
    let needed = open.into_iter().find(|(name, _)| needs(library, path, &mounts, name));
    let Some((name, targets)) = needed else { return vec![chosen] };
    let own = targets.iter().find(|target| below(path, target).is_some());
    let targets = own.map_or(*targets, std::slice::from_ref);
    let with = |target: &&'a str| chosen.iter().copied().chain([(*name, *target)]).collect();
    targets.iter().flat_map(|target| combinations(library, path, alternatives, with(target))).collect()
}

/// Whether a module, or what it imports, has an import below `name` that means nothing yet.
fn needs(library: &Library, path: &str, mounts: &Mounts, name: &str) -> bool {
    let mut seen = BTreeSet::new();
    let mut open: Vec<&Arc<Module>> = library.module(path).into_iter().collect();
    while let Some(module) = open.pop() {
        if !seen.insert(&module.path) {
            continue;
        }
        for import in &module.imports {
            match mounts.resolve(library, &import.module) {
                Some(imported) => open.push(imported),
                None if below(&import.module.join("/"), name).is_some() => return true,
                None => {}
            }
        }
    }
    false
}
