//! A linked text checked by naga, its errors placed in the authors' files.

use std::sync::Arc;

use naga::front::wgsl;
use naga::valid::{Capabilities, ModuleInfo, ValidationError, ValidationFlags, Validator};
use naga::{Span, WithSpan};
use voxlume_fault::{Fault, Faults, Place, nearest};

use crate::explain::{reason, statement, subject};
use crate::linked::Linked;
use crate::module::{Location, Module};
use crate::mount::below;
use crate::subset;
use crate::token::{Cursor, Kind};

/// What every WebGPU device can do: of naga's capabilities these are no optional feature of the standard.
const WEBGPU: Capabilities = Capabilities::MULTISAMPLED_SHADING
    .union(Capabilities::CUBE_ARRAY_TEXTURES)
    .union(Capabilities::SHADER_FLOAT16_IN_FLOAT32);

/// A linked and valid WGSL text.
#[derive(Clone, Debug)]
pub struct Shader {
    /// The text.
    pub wgsl: String,
    /// The text as naga's representation.
    pub module: naga::Module,
    /// What naga's validator found out about it.
    pub info: ModuleInfo,
    pub(crate) modules: Vec<Arc<Module>>,
}

impl Shader {
    /// Whether it has a module at `path`, or below it.
    pub fn links(&self, path: &str) -> bool {
        self.modules.iter().any(|module| below(&module.path, path).is_some())
    }
}

impl Linked {
    /// Parses and validates the text for a device without any optional WebGPU feature.
    ///
    /// # Errors
    /// naga's first error, placed in the file, line and column of the module that it is in; else every
    /// storage texture whose format or access WebGPU does not guarantee, and every workgroup size that is an
    /// override.
    pub fn check(self) -> Result<Shader, Faults> {
        let options = wgsl::Options { parse_doc_comments: false, capabilities: WEBGPU };
        let module =
            wgsl::Frontend::new_with_options(options).parse(&self.wgsl).map_err(|e| self.unparsed(&e))?;
        let validated = Validator::new(ValidationFlags::all(), WEBGPU).validate(&module);
        let info = validated.map_err(|error| self.invalid(&module, &error))?;
        subset::check(&self, &module).into_result(())?;
        Ok(Shader { wgsl: self.wgsl, module, info, modules: self.modules })
    }

    /// A fault at the first label; the other labels become notes.
    fn unparsed(&self, error: &wgsl::ParseError) -> Fault {
        let mut fault = Fault::new(error.message());
        for (span, label) in error.labels() {
            fault = match fault.place {
                None => self.placed(fault, span, label),
                Some(_) => self.noted(fault, span, label),
            };
        }
        if error.message().starts_with("no definition in scope for identifier") {
            fault = match fault.place.as_ref().and_then(|place| self.name_hint(place)) {
                Some(hint) => fault.note(hint),
                None => fault,
            };
        }
        error.notes().fold(fault, Fault::note)
    }

    fn invalid(&self, module: &naga::Module, error: &WithSpan<ValidationError>) -> Fault {
        let (kind, name) = subject(error.as_inner());
        let name = name.filter(|name| !name.is_empty());
        let fault = Fault::new(match name {
            Some(name) => format!("invalid {kind} `{name}`"),
            None => format!("invalid {kind}"),
        });
        let reason = reason(module, error.as_inner());
        if let Some(span) = statement(module, error.as_inner()) {
            return self.placed(fault, span, &reason);
        }
        // Labels in words say more than the numbered ones, narrow ones more than wide ones.
        let numbered = |label: &str| label.starts_with("naga::");
        let width = |span: &Span| span.to_range().map(|range| range.len());
        if let Some((span, _)) = error.spans().min_by_key(|(span, label)| (numbered(label), width(span))) {
            return self.placed(fault, *span, &reason);
        }
        self.at_declaration(fault, name.unwrap_or_default(), &reason)
    }

    /// Where the name at a place, which is not in scope, could come from.
    fn name_hint(&self, place: &Place) -> Option<String> {
        let name = place.source.text.get(place.span.clone())?;
        if let Some(owner) = self.library.declaring(name).next() {
            return Some(format!("add `import {}::{name};`", self.mounts.written(&owner.path)));
        }
        let cursor = Cursor::new(&place.source.text);
        let words = cursor
            .tokens()
            .iter()
            .filter(|token| token.kind == Kind::Word)
            .map(|token| cursor.text_of(*token));
        let near = nearest(name, words.filter(|word| *word != name))?;
        Some(format!("did you mean `{near}`?"))
    }

    pub(crate) fn at_declaration(&self, fault: Fault, name: &str, label: &str) -> Fault {
        let declared = self.modules.iter().find_map(|module| Some((module, module.declaration(name)?)));
        match declared {
            Some((module, declaration)) => fault.at(&module.source, declaration.span.clone(), label),
            None => fault.note(label),
        }
    }

    pub(crate) fn placed(&self, fault: Fault, span: Span, label: &str) -> Fault {
        match span.to_range().and_then(|range| self.trace(range)) {
            Some((module, span)) => fault.at(self.source(module), span, label),
            None => fault,
        }
    }

    fn noted(&self, fault: Fault, span: Span, label: &str) -> Fault {
        match span.to_range().and_then(|range| self.trace(range)) {
            Some((module, span)) => {
                let note = format!("{}: {label}", Location(self.source(module), span.start));
                fault.note(note.trim_end_matches(": "))
            }
            None => fault,
        }
    }
}
