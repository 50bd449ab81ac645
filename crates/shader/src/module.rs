//! One WGSL file: what it imports, declares and uses.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use voxlume_fault::{Fault, Source};

use crate::import::{Import, import};
use crate::limits;
use crate::scope::Walker;
use crate::token::{Cursor, Kind};

/// A module as its text shows it, before any other module is known.
#[derive(Debug)]
pub(crate) struct Module {
    /// `common/grid`
    pub path: String,
    pub source: Arc<Source>,
    pub imports: Vec<Import>,
    /// `enable`, `requires` and `diagnostic` directives, which WGSL wants before all declarations.
    pub directives: Vec<Range<usize>>,
    pub declarations: Vec<Declaration>,
    /// The names used that are no locals, in the order of the text.
    pub uses: Vec<Range<usize>>,
    /// Where the `var` of each resource is, in the order of the text.
    pub resources: Vec<usize>,
    /// What is wrong already.
    pub faults: Vec<Fault>,
}

/// A name that a module declares.
#[derive(Debug)]
pub(crate) struct Declaration {
    pub name: String,
    /// Where the name is.
    pub span: Range<usize>,
    /// A struct's members, each with its `///` lines.
    pub members: Vec<(String, String)>,
}

impl Module {
    pub fn scan(path: &str, source: Arc<Source>) -> Module {
        let mut cursor = Cursor::new(&source.text);
        let (mut imports, mut directives, mut faults) = (Vec::new(), Vec::new(), Vec::new());
        faults.extend(limits::exceeded(&cursor, &source));
        while let Some(token) = cursor.peek().filter(|token| token.kind == Kind::Word) {
            match cursor.text_of(token) {
                "enable" | "requires" | "diagnostic" => directives.push(token.start..cursor.skip_past(';')),
                "import" => {
                    cursor.next();
                    match import(&mut cursor, token, &source) {
                        Ok(import) => imports.push(import),
                        Err(fault) => faults.push(fault),
                    }
                }
                _ => break,
            }
        }
        let mut walker = Walker::new(cursor, &source, faults);
        walker.walk();
        let Walker { declarations, uses, resources, faults, .. } = walker;
        Module { path: path.to_owned(), imports, directives, declarations, uses, resources, faults, source }
    }

    pub fn declaration(&self, name: &str) -> Option<&Declaration> {
        self.declarations.iter().find(|declaration| declaration.name == name)
    }

    pub fn imports_item(&self, name: &str) -> bool {
        self.imports.iter().any(|import| import.items.iter().any(|(item, _)| item == name))
    }
}

/// `wgsl/common/grid.wgsl:3:7`, as notes give places beside the first.
pub(crate) struct Location<'a>(pub &'a Source, pub usize);

impl fmt::Display for Location<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let before = &self.0.text[..self.0.text.floor_char_boundary(self.1)];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        write!(f, "{}:{line}:{}", self.0.name, before[line_start..].chars().count() + 1)
    }
}
