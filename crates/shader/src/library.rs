//! The modules that can be imported.

use std::collections::BTreeMap;
use std::sync::Arc;

use voxlume_fault::Source;

use crate::module::Module;

/// Modules by path, such as `common/grid`, `format/isotropic/sample`, `effect/diffuse`, `pass/light`.
#[derive(Clone, Debug, Default)]
pub struct Library {
    modules: BTreeMap<String, Arc<Module>>,
}

impl Library {
    /// The modules that come with Voxlume: every file of its `wgsl` folder. Their sources are named
    /// after it: `wgsl/common/grid.wgsl`.
    pub fn builtin() -> Library {
        const MODULES: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/builtin.rs"));
        let mut library = Library::empty();
        for (path, text) in MODULES {
            library.insert(path, Source::new(format!("wgsl/{path}.wgsl"), *text));
        }
        library
    }

    /// A library of no modules.
    pub fn empty() -> Library {
        Library::default()
    }

    /// Adds a module, in the place of the one that has the path already. What is wrong with it is told
    /// when it is linked.
    pub fn insert(&mut self, path: &str, source: Arc<Source>) {
        self.modules.insert(path.to_owned(), Arc::new(Module::scan(path, source)));
    }

    /// The text of a module.
    pub fn get(&self, path: &str) -> Option<&Arc<Source>> {
        self.module(path).map(|module| &module.source)
    }

    /// The paths of all modules, sorted.
    pub fn paths(&self) -> impl Iterator<Item = &str> {
        self.modules.keys().map(String::as_str)
    }

    pub(crate) fn module(&self, path: &str) -> Option<&Arc<Module>> {
        self.modules.get(path)
    }

    /// The modules that declare `name`.
    pub(crate) fn declaring(&self, name: &str) -> impl Iterator<Item = &Arc<Module>> {
        self.modules.values().filter(move |module| module.declaration(name).is_some())
    }
}
