//! Linking: one WGSL text of a module and all that it imports.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use voxlume_fault::{Fault, Faults, nearest, one_of, suggest};

use crate::import::Import;
use crate::library::Library;
use crate::limits::{DECLARATIONS, RESOURCES};
use crate::linked::{Linked, assemble};
use crate::module::{Location, Module};
use crate::mount::Mounts;

/// Links the module at `entry` with all that it imports, each module once, what is imported before what
/// imports it, and numbers their resources. A mount `(name, target)` makes import paths that start with `name` mean `target`:
/// `("format", "format/isotropic")` lets `package::format::sample` be the module
/// `format/isotropic/sample`, and `("effect", "effect/diffuse")` lets `package::effect` be the one module
/// `effect/diffuse`. Names stay as written.
///
/// # Errors
/// All at once: an unknown module, an item that its module lacks, a malformed import, a name that two
/// modules declare, a resource that a module numbers itself, a use of another module's name without an import, and texts so long that
/// a compiler's recursion might not fit its stack.
pub fn link(library: &Library, entry: &str, mounts: &[(&str, &str)]) -> Result<Linked, Faults> {
    let mounts = Mounts::new(mounts);
    let Some(module) = library.module(entry) else {
        let message = format!("unknown module `{entry}`");
        let paths: Vec<&str> = library.paths().collect();
        return Err(Fault::new(message).note(suggest(entry, paths)).into());
    };
    let mut linker = Linker {
        library,
        mounts: &mounts,
        seen: BTreeSet::new(),
        order: Vec::new(),
        faults: Faults::default(),
    };
    linker.add(module);
    let Linker { order, mut faults, .. } = linker;
    let declared = duplicates(&order, &mut faults);
    for module in &order {
        unimported(module, &declared, &mounts, &mut faults);
    }
    let resources = order.iter().map(|module| module.resources.len()).sum();
    for (count, most, what) in
        [(declared.len(), DECLARATIONS, "declarations"), (resources, RESOURCES, "resources")]
    {
        if count > most {
            faults.push(Fault::new(format!("`{entry}` links more than {most} {what}")));
        }
    }
    faults.into_result(())?;
    Ok(assemble(library, mounts, order))
}

struct Linker<'a> {
    library: &'a Library,
    mounts: &'a Mounts,
    seen: BTreeSet<&'a str>,
    order: Vec<Arc<Module>>,
    faults: Faults,
}

impl<'a> Linker<'a> {
    fn add(&mut self, module: &'a Arc<Module>) {
        if !self.seen.insert(&module.path) {
            return;
        }
        self.faults.extend(module.faults.iter().cloned());
        for import in &module.imports {
            match self.mounts.resolve(self.library, &import.module) {
                Some(imported) => {
                    self.items(module, import, imported);
                    self.add(imported);
                }
                None => self.unknown(module, import),
            }
        }
        self.order.push(Arc::clone(module));
    }

    fn items(&mut self, module: &Module, import: &Import, imported: &Module) {
        // A module that is malformed itself may declare more than could be read.
        let items = import.items.iter().filter(|_| imported.faults.is_empty());
        for (item, span) in items {
            if imported.declaration(item).is_none() {
                let names = imported.declarations.iter().map(|declaration| declaration.name.as_str());
                let message = format!("{} declares no `{item}`", imported.source.name);
                self.faults.push(Fault::new(message).at(&module.source, span.clone(), suggest(item, names)));
            }
        }
    }

    fn unknown(&mut self, module: &Module, import: &Import) {
        let written = format!("package::{}", import.module.join("::"));
        let choices: Vec<String> = self.library.paths().map(|path| self.mounts.written(path)).collect();
        let label = did_you_mean(&written, &choices);
        let fault = Fault::new(format!("unknown module `{written}`"));
        let mut fault = fault.at(&module.source, import.module_span.clone(), label);
        // `import package::common::cone;` names the module where an item should be.
        if let [(item, _)] = import.items.as_slice()
            && let whole = format!("{written}::{item}")
            && choices.contains(&whole)
        {
            fault = fault.note(format!("`{whole}` is a module: name what to import from it"));
        }
        self.faults.push(fault);
    }
}

/// The choice whose last name is near, those in the same folder first; else all in the folder, if it is one.
fn did_you_mean(written: &str, choices: &[String]) -> String {
    let split = |path| str::rsplit_once(path, "::").unwrap_or(("", path));
    let (folder, name) = split(written);
    let all: Vec<&str> = choices.iter().map(String::as_str).collect();
    let beside: Vec<&str> = all.iter().copied().filter(|choice| split(choice).0 == folder).collect();
    for choices in [&beside, &all] {
        let near = nearest(name, choices.iter().map(|choice| split(choice).1));
        if let Some(choice) = near.and_then(|near| choices.iter().find(|choice| split(choice).1 == near)) {
            return format!("did you mean `{choice}`?");
        }
    }
    one_of(if beside.is_empty() { all } else { beside })
}

/// Where each name is declared; a second declaration is a fault.
fn duplicates<'m>(
    order: &'m [Arc<Module>],
    faults: &mut Faults,
) -> BTreeMap<&'m str, (&'m Module, Range<usize>)> {
    let mut declared: BTreeMap<&str, (&Module, Range<usize>)> = BTreeMap::new();
    for module in order {
        for declaration in &module.declarations {
            if let Some((first, span)) = declared.get(declaration.name.as_str()) {
                let label = format!("also declared at {}", Location(&first.source, span.start));
                let fault = Fault::new(format!("`{}` is declared twice", declaration.name));
                faults.push(fault.at(&module.source, declaration.span.clone(), label));
            } else {
                declared.insert(&declaration.name, (module, declaration.span.clone()));
            }
        }
    }
    declared
}

/// Names of other modules that the linked text would resolve though `module` does not import them.
fn unimported(
    module: &Module,
    declared: &BTreeMap<&str, (&Module, Range<usize>)>,
    mounts: &Mounts,
    faults: &mut Faults,
) {
    let mut told = BTreeSet::new();
    for span in &module.uses {
        let name = &module.source.text[span.clone()];
        if let Some((owner, _)) = declared.get(name)
            && module.declaration(name).is_none()
            && !module.imports_item(name)
            && told.insert(name)
        {
            let label = format!("declared in {}, not imported here", owner.source.name);
            let fault =
                Fault::new(format!("`{name}` is not imported")).at(&module.source, span.clone(), label);
            faults.push(fault.note(format!("add `import {}::{name};`", mounts.written(&owner.path))));
        }
    }
}
