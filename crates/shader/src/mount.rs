//! Mounts: import paths that mean another path of the library.

use std::sync::Arc;

use crate::library::Library;
use crate::module::Module;

/// Pairs of a path and the path that it means: with `("format", "format/isotropic")`,
/// `package::format::sample` is the module `format/isotropic/sample`; with
/// `("effect", "effect/diffuse")`, `package::effect` is the module `effect/diffuse`.
#[derive(Clone, Debug)]
pub(crate) struct Mounts(Vec<(String, String)>);

impl Mounts {
    pub fn new(mounts: &[(&str, &str)]) -> Mounts {
        Mounts(mounts.iter().map(|(name, target)| (name.to_string(), target.to_string())).collect())
    }

    /// The module that an import means. A path below a mount that the mounted folder lacks is taken as
    /// written, so that the modules of one format can share those of another by its full name.
    pub fn resolve<'l>(&self, library: &'l Library, written: &[String]) -> Option<&'l Arc<Module>> {
        let written = written.join("/");
        let mounted = self.0.iter().find_map(|(name, target)| {
            let rest = below(&written, name)?;
            library.module(&format!("{target}{rest}"))
        });
        mounted.or_else(|| library.module(&written))
    }

    /// How an import names a module: `package::format::sample`.
    pub fn written(&self, path: &str) -> String {
        let mounted =
            self.0.iter().find_map(|(name, target)| Some(format!("{name}{}", below(path, target)?)));
        format!("package::{}", mounted.as_deref().unwrap_or(path).replace('/', "::"))
    }
}

/// What follows `folder` in `path`, slash included; nothing if `path` is `folder` itself.
pub(crate) fn below<'a>(path: &'a str, folder: &str) -> Option<&'a str> {
    path.strip_prefix(folder).filter(|rest| rest.is_empty() || rest.starts_with('/'))
}
