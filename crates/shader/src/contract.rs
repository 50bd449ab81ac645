//! What a module must declare to take its part.

use std::fmt;

use voxlume_fault::{Fault, Faults, nearest};

use crate::check::Shader;
use crate::reflect::Signature;

/// The functions that modules of one kind must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contract {
    /// The kind of module: `effect`.
    pub what: &'static str,
    /// The paths of such modules, with `*` for the name that a module of the kind goes by.
    pub modules: &'static str,
    /// The functions.
    pub functions: &'static [Requirement],
}

/// A function that a contract asks for. Argument names are for the reader; types and their order count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Requirement {
    /// Its name.
    pub name: &'static str,
    /// Name and type of each argument.
    pub arguments: &'static [(&'static str, &'static str)],
    /// The type returned.
    pub result: Option<&'static str>,
}

/// An effect over the screen.
pub const EFFECT: Contract = Contract {
    what: "effect",
    modules: "effect/*",
    functions: &[Requirement {
        name: "effect",
        arguments: &[("surface", "Surface"), ("params", "Params")],
        result: Some("vec4f"),
    }],
};

/// How a storage format is sampled: premultiplied radiance coming back along the direction of travel, and
/// opacity.
pub const FORMAT_SAMPLE: Contract = Contract {
    what: "format",
    modules: "format/*/sample",
    functions: &[Requirement {
        name: "voxel_sample",
        arguments: &[("uvw", "vec3f"), ("level", "f32"), ("direction", "vec3f")],
        result: Some("vec4f"),
    }],
};

/// What a tracer meets in the directions of a lobe: the mean radiance that arrives, the sky's where nothing is met, the mean
/// opacity and the distance of the first hit; and the opacity alone, in less time, which loses weight with the distance t as
/// 1/(1 + `falloff`·t). Lengths are voxels.
pub const TRACER: Contract = Contract {
    what: "tracer",
    modules: "tracer/*/trace",
    functions: &[
        Requirement {
            name: "trace_gather",
            arguments: &[("apex", "Apex"), ("lobe", "Lobe"), ("reach", "Reach")],
            result: Some("Gathered"),
        },
        Requirement {
            name: "trace_opacity",
            arguments: &[("apex", "Apex"), ("lobe", "Lobe"), ("reach", "Reach"), ("falloff", "f32")],
            result: Some("f32"),
        },
    ],
};

/// Every contract.
pub const CONTRACTS: [Contract; 3] = [EFFECT, FORMAT_SAMPLE, TRACER];

impl Contract {
    /// The contract that a module at this path must fulfil.
    pub fn of(module_path: &str) -> Option<&'static Contract> {
        CONTRACTS.iter().find(|contract| contract.name_in(module_path).is_some())
    }

    /// What `*` stands for in a module's path.
    fn name_in<'a>(&self, module_path: &'a str) -> Option<&'a str> {
        let (before, after) = self.modules.split_once('*')?;
        module_path.strip_prefix(before)?.strip_suffix(after).filter(|name| !name.contains('/'))
    }
}

impl Shader {
    /// Whether the linked module at `module_path` declares what a contract asks for.
    ///
    /// # Errors
    /// Each function that is missing or has other types.
    pub fn fulfils(&self, contract: &Contract, module_path: &str) -> Result<(), Faults> {
        let mut faults = Faults::default();
        let subject = format!("{} `{}`", contract.what, contract.name_in(module_path).unwrap_or(module_path));
        let Some(module) = self.modules.iter().find(|module| module.path == module_path) else {
            return Err(Fault::new(format!("{subject} is not linked")).into());
        };
        for required in contract.functions {
            let declared = module.declaration(required.name);
            let signature = declared.and_then(|declared| self.function(&declared.name));
            if signature.as_ref().is_some_and(|signature| required.is_met_by(signature)) {
                continue;
            }
            let fault = Fault::new(format!("{subject} must have `{required}`"));
            faults.push(match (declared, signature) {
                (Some(declared), Some(signature)) => {
                    let label = format!("is `{}`", required.with(&signature));
                    fault.at(&module.source, declared.span.clone(), label)
                }
                (Some(declared), None) => {
                    fault.at(&module.source, declared.span.clone(), "is no plain function")
                }
                (None, _) => {
                    let names = module.declarations.iter().map(|declared| declared.name.as_str());
                    match nearest(required.name, names).and_then(|near| module.declaration(near)) {
                        Some(near) => fault.at(&module.source, near.span.clone(), "did you mean this?"),
                        None => fault.at(&module.source, 0..0, "nowhere in this file"),
                    }
                }
            });
        }
        faults.into_result(())
    }
}

impl Requirement {
    fn is_met_by(&self, signature: &Signature) -> bool {
        let types = signature.arguments.iter().map(|(_, ty)| ty.as_str());
        types.eq(self.arguments.iter().map(|(_, ty)| *ty)) && signature.result.as_deref() == self.result
    }

    /// This function's name with the types of another.
    fn with(&self, signature: &Signature) -> String {
        let arguments = signature.arguments.iter().map(|(name, ty)| (name.as_str(), ty.as_str()));
        written(self.name, arguments, signature.result.as_deref())
    }
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&written(self.name, self.arguments.iter().copied(), self.result))
    }
}

fn written<'a>(
    name: &str,
    arguments: impl Iterator<Item = (&'a str, &'a str)>,
    result: Option<&str>,
) -> String {
    let arguments: Vec<String> = arguments.map(|(name, ty)| format!("{name}: {ty}")).collect();
    let result = result.map_or_else(String::new, |ty| format!(" -> {ty}"));
    format!("fn {name}({}){result}", arguments.join(", "))
}
