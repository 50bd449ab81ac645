//! What a module declares, and which names it uses without declaring them.

use std::ops::Range;
use std::sync::Arc;

use voxlume_fault::{Fault, Source};

use crate::module::Declaration;
use crate::resource::is_number;
use crate::token::{Cursor, Kind, Token};

/// Walks the declarations of a module. A full parse is naga's job, on the linked text; this one knows
/// just enough grammar to tell which names are local.
pub(crate) struct Walker<'a> {
    pub cursor: Cursor<'a>,
    pub source: &'a Arc<Source>,
    pub declarations: Vec<Declaration>,
    /// Names that no scope of the module declares, its own top level aside.
    pub uses: Vec<Range<usize>>,
    /// Where the `var` of each resource is.
    pub resources: Vec<usize>,
    pub faults: Vec<Fault>,
    scopes: Vec<Scope<'a>>,
    /// Parameters before their body's `{`, a local before its statement's `;`.
    pending: Vec<&'a str>,
}

struct Scope<'a> {
    open: Token,
    names: Vec<&'a str>,
}

impl<'a> Walker<'a> {
    pub fn new(cursor: Cursor<'a>, source: &'a Arc<Source>, faults: Vec<Fault>) -> Walker<'a> {
        Walker {
            cursor,
            source,
            declarations: Vec::new(),
            uses: Vec::new(),
            resources: Vec::new(),
            faults,
            scopes: Vec::new(),
            pending: Vec::new(),
        }
    }

    pub fn walk(&mut self) {
        while let Some(token) = self.cursor.next() {
            match token.kind {
                Kind::Word => self.word(token),
                Kind::Symbol('{') => {
                    self.scopes.push(Scope { open: token, names: std::mem::take(&mut self.pending) });
                }
                Kind::Symbol('}') => {
                    self.scopes.pop();
                }
                // A local is in scope from the end of its statement on.
                Kind::Symbol(';') => {
                    let names = std::mem::take(&mut self.pending);
                    if let Some(scope) = self.scopes.last_mut() {
                        scope.names.extend(names);
                    }
                }
                _ => self.other(token),
            }
        }
        self.ending();
    }

    /// What would spill into the next module of the linked text is told here, where it belongs.
    fn ending(&mut self) {
        if !self.faults.is_empty() {
            return;
        }
        if let Some(scope) = self.scopes.last() {
            self.unclosed(scope.open);
        } else if let Some(last) = self.cursor.tokens().last()
            && !matches!(last.kind, Kind::Symbol(';' | '}'))
        {
            let fault =
                Fault::new("unfinished declaration").at(self.source, last.span(), "expected `;` after this");
            self.faults.push(fault);
        }
    }

    fn unclosed(&mut self, open: Token) {
        self.faults.push(Fault::new("unclosed `{`").at(self.source, open.span(), "has no `}`"));
    }

    fn word(&mut self, token: Token) {
        match self.cursor.text_of(token) {
            "fn" => {
                self.name();
                self.parameters();
            }
            "struct" => {
                self.name();
                self.members();
            }
            "var" => self.variable(token),
            "let" | "const" | "override" | "alias" => self.name(),
            "import" => {
                let fault = Fault::new("misplaced import").at(
                    self.source,
                    token.span(),
                    "imports come before all declarations",
                );
                self.faults.push(fault);
                self.cursor.skip_past(';');
            }
            _ => self.used(token),
        }
    }

    pub(crate) fn at_module_scope(&self) -> bool {
        self.scopes.is_empty()
    }

    fn used(&mut self, token: Token) {
        let word = self.cursor.text_of(token);
        if !self.scopes.iter().any(|scope| scope.names.contains(&word)) {
            self.uses.push(token.span());
        }
    }

    /// Attributes and member accesses, whose words are no uses.
    fn other(&mut self, token: Token) {
        match token.kind {
            Kind::Symbol('.') => {
                self.cursor.word();
            }
            Kind::Symbol('@') => {
                let attribute = self.cursor.word().map(|word| self.cursor.text_of(word));
                if attribute.is_some_and(is_number) {
                    self.numbered(token);
                } else if matches!(attribute, Some("builtin" | "interpolate" | "diagnostic")) {
                    // Their arguments are words of their own too; those of the others are expressions.
                    self.cursor.skip_past(')');
                }
            }
            _ => {}
        }
    }

    /// The name that a declaration gives.
    pub(crate) fn name(&mut self) {
        let Some(token) = self.cursor.word() else { return };
        let name = self.cursor.text_of(token);
        if self.at_module_scope() {
            let declaration = Declaration { name: name.to_owned(), span: token.span(), members: Vec::new() };
            self.declarations.push(declaration);
        } else {
            self.pending.push(name);
        }
    }

    /// `(a: A, b: B)`
    fn parameters(&mut self) {
        if self.cursor.symbol('(').is_none() {
            return;
        }
        let mut depth = 1;
        while let Some(token) = self.cursor.next() {
            match token.kind {
                Kind::Symbol('(') => depth += 1,
                Kind::Symbol(')') => depth -= 1,
                Kind::Word if depth == 1 && self.cursor.symbol(':').is_some() => {
                    self.pending.push(self.cursor.text_of(token));
                }
                Kind::Word => self.used(token),
                _ => self.other(token),
            }
            if depth == 0 {
                return;
            }
        }
    }

    /// `{ a: A, b: B }`
    fn members(&mut self) {
        let Some(open) = self.cursor.symbol('{') else { return };
        let mut docs = self.cursor.docs_here();
        while let Some(token) = self.cursor.next() {
            match token.kind {
                Kind::Symbol('}') => return,
                // The first brace of what follows the struct.
                Kind::Symbol('{') => break,
                Kind::Symbol(',') => docs = self.cursor.docs_here(),
                Kind::Word if self.cursor.symbol(':').is_some() => {
                    let member = (self.cursor.text_of(token).to_owned(), std::mem::take(&mut docs));
                    if let Some(declaration) = self.declarations.last_mut() {
                        declaration.members.push(member);
                    }
                }
                Kind::Word => self.used(token),
                _ => self.other(token),
            }
        }
        self.unclosed(open);
    }
}
