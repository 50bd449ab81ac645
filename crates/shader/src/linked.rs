//! The linked text, and where each stretch of it came from.

use std::ops::Range;
use std::sync::Arc;

use voxlume_fault::Source;

use crate::library::Library;
use crate::module::Module;
use crate::mount::Mounts;
use crate::resource::attributes;

/// One WGSL text out of several modules, not yet checked.
#[derive(Clone, Debug)]
pub struct Linked {
    /// The text.
    pub wgsl: String,
    pub(crate) segments: Vec<Segment>,
    pub(crate) modules: Vec<Arc<Module>>,
    pub(crate) library: Library,
    pub(crate) mounts: Mounts,
}

/// A stretch of the linked text that is a stretch of a module, byte for byte apart from blanks.
#[derive(Clone, Debug)]
pub(crate) struct Segment {
    start: usize,
    pub module: usize,
    span: Range<usize>,
}

impl Segment {
    /// Where a place of the linked text is in the author's file.
    fn place(&self, linked: usize) -> usize {
        (self.span.start + linked.saturating_sub(self.start)).min(self.span.end)
    }
}

impl Linked {
    /// The stretch of an author's file that a stretch of the linked text came from, with the module's
    /// index. What the linker wrote counts to the end of what is before it; a stretch ends with its module.
    pub(crate) fn trace(&self, linked: Range<usize>) -> Option<(usize, Range<usize>)> {
        let first = self.segment_at(linked.start)?;
        let last = self.segment_at(linked.end).filter(|last| last.module == first.module);
        let end = last.map_or(first.span.end, |last| last.place(linked.end));
        Some((first.module, first.place(linked.start)..end))
    }

    fn segment_at(&self, linked: usize) -> Option<&Segment> {
        let after = self.segments.partition_point(|segment| segment.start <= linked);
        self.segments.get(after.saturating_sub(1))
    }

    pub(crate) fn source(&self, module: usize) -> &Arc<Source> {
        &self.modules[module].source
    }
}

/// Puts the modules one after the other, directives first, as WGSL wants them, and numbers their resources.
pub(crate) fn assemble(library: &Library, mounts: Mounts, modules: Vec<Arc<Module>>) -> Linked {
    let mut wgsl = String::new();
    let mut segments = Vec::new();
    for (index, module) in modules.iter().enumerate() {
        for span in &module.directives {
            segments.push(Segment { start: wgsl.len(), module: index, span: span.clone() });
            wgsl.push_str(&module.source.text[span.clone()]);
            wgsl.push('\n');
        }
    }
    let mut bindings = 0..;
    for (index, module) in modules.iter().enumerate() {
        // A line break in a file's name must not end the comment.
        wgsl.push_str(&format!("// {}\n", module.source.name.escape_debug()));
        let text = blanked(module);
        let mut start = 0;
        for (end, binding) in module.resources.iter().copied().zip(&mut bindings) {
            segments.push(Segment { start: wgsl.len(), module: index, span: start..end });
            wgsl.push_str(&text[start..end]);
            wgsl.push_str(&attributes(binding));
            start = end;
        }
        segments.push(Segment { start: wgsl.len(), module: index, span: start..text.len() });
        wgsl.push_str(&text[start..]);
        wgsl.push('\n');
    }
    Linked { wgsl, segments, modules, library: library.clone(), mounts }
}

/// A module's text with blanks of the same length for its imports and directives, which keep lines and columns.
fn blanked(module: &Module) -> String {
    let imports = module.imports.iter().map(|import| import.span.clone());
    let mut text = module.source.text.to_string();
    for span in imports.chain(module.directives.iter().cloned()) {
        let blanks: String =
            text[span.clone()].bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }).collect();
        text.replace_range(span, &blanks);
    }
    text
}
