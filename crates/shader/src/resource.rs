//! Resource variables: authors name them, the linker numbers them.

use voxlume_fault::Fault;

use crate::scope::Walker;
use crate::token::Token;

/// What the linker writes in front of a resource variable. All are in one group, whose bindings count from 0 in
/// the order of the linked text.
pub(crate) fn attributes(binding: usize) -> String {
    format!("@group(0) @binding({binding}) ")
}

impl Walker<'_> {
    /// `var<storage, read> name`, after `var`, which is at `start`. A variable of a module is a resource unless its
    /// address space is memory of an invocation or a workgroup; textures and samplers have no address space.
    pub(crate) fn variable(&mut self, start: Token) {
        let mut is_resource = self.at_module_scope();
        if self.cursor.symbol('<').is_some() {
            let space = self.cursor.word().map(|word| self.cursor.text_of(word));
            is_resource &= matches!(space, Some("storage" | "uniform"));
            // The access mode is a word of its own.
            self.cursor.skip_past('>');
        }
        if is_resource {
            self.resources.push(start.start);
        }
        self.name();
    }

    /// `@group(0) @binding(1)`, after the first word; its `@` is at `start`.
    pub(crate) fn numbered(&mut self, start: Token) {
        let mut end = self.cursor.skip_past(')');
        if self.cursor.symbol('@').is_some()
            && let Some(word) = self.cursor.word()
            && is_number(self.cursor.text_of(word))
        {
            end = self.cursor.skip_past(')');
        }
        let fault = Fault::new("a module may not number its resources");
        let label = "remove this: the linker gives `@group` and `@binding`";
        self.faults.push(fault.at(self.source, start.start..end, label));
    }
}

/// Whether an attribute numbers a resource.
pub(crate) fn is_number(attribute: &str) -> bool {
    matches!(attribute, "group" | "binding")
}
