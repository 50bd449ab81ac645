//! The linked text, and where each stretch of it came from.

use std::ops::Range;
use std::sync::Arc;

use voxlume_fault::Source;

use crate::library::Library;
use crate::module::Module;
use crate::mount::Mounts;

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

impl Linked {
    /// The stretch of an author's file that a stretch of the linked text came from, with the module's
    /// index. What is in between two modules counts to the first.
    pub(crate) fn trace(&self, linked: Range<usize>) -> Option<(usize, Range<usize>)> {
        let after = self.segments.partition_point(|segment| segment.start <= linked.start);
        let segment = self.segments.get(after.saturating_sub(1))?;
        let place = |at: usize| (segment.span.start + at.saturating_sub(segment.start)).min(segment.span.end);
        Some((segment.module, place(linked.start)..place(linked.end)))
    }

    pub(crate) fn source(&self, module: usize) -> &Arc<Source> {
        &self.modules[module].source
    }
}

/// Puts the modules one after the other, directives first, as WGSL wants them.
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
    for (index, module) in modules.iter().enumerate() {
        // A line break in a file's name must not end the comment.
        wgsl.push_str(&format!("// {}\n", module.source.name.escape_debug()));
        segments.push(Segment { start: wgsl.len(), module: index, span: 0..module.source.text.len() });
        let mut at = 0;
        for span in blanked(module) {
            wgsl.push_str(&module.source.text[at..span.start]);
            // Blanks of the same length keep lines and columns.
            wgsl.extend(
                module.source.text[span.clone()].bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }),
            );
            at = span.end;
        }
        wgsl.push_str(&module.source.text[at..]);
        wgsl.push('\n');
    }
    Linked { wgsl, segments, modules, library: library.clone(), mounts }
}

/// The imports and directives of a module, in order.
fn blanked(module: &Module) -> Vec<Range<usize>> {
    let imports = module.imports.iter().map(|import| import.span.clone());
    let mut spans: Vec<_> = imports.chain(module.directives.iter().cloned()).collect();
    spans.sort_by_key(|span| span.start);
    spans
}
