//! Import statements: `import package::common::cone::{cone_sample, Cone};`.

use std::ops::Range;
use std::sync::Arc;

use voxlume_fault::{Fault, Source};

use crate::token::{Cursor, Token};

/// One import statement.
#[derive(Debug)]
pub(crate) struct Import {
    /// The whole statement.
    pub span: Range<usize>,
    /// The module as written, without `package`: `["common", "cone"]`.
    pub module: Vec<String>,
    /// Where the module's path is written.
    pub module_span: Range<usize>,
    /// The items and where each is written.
    pub items: Vec<(String, Range<usize>)>,
}

/// Parses what follows the word `import`, which is `start`. On a fault the cursor is past the
/// statement's semicolon.
pub(crate) fn import(cursor: &mut Cursor, start: Token, source: &Arc<Source>) -> Result<Import, Fault> {
    parse(cursor, start).map_err(|expected| {
        let fault = Fault::new("malformed import")
            .at(source, cursor.here(), format!("expected {expected}"))
            .note("write `import package::folder::module::name;`")
            .note("or `import package::folder::module::{name, other};`");
        cursor.skip_past(';');
        fault
    })
}

fn parse(cursor: &mut Cursor, start: Token) -> Result<Import, &'static str> {
    let package = cursor.peek().filter(|token| cursor.text_of(*token) == "package").ok_or("`package`")?;
    cursor.next();
    colons(cursor)?;
    let mut path = vec![cursor.word().ok_or("a name")?];
    let mut items = Vec::new();
    // The last name of a path without braces is the item.
    loop {
        if cursor.symbol(';').is_some() {
            items.extend(path.pop());
            break;
        }
        colons(cursor).map_err(|_| if path.len() > 1 { "`::` or `;`" } else { "`::`" })?;
        if cursor.symbol('{').is_some() {
            items = list(cursor)?;
            cursor.symbol(';').ok_or("`;`")?;
            break;
        }
        path.push(cursor.word().ok_or("a name or `{`")?);
    }
    let module_end = path.last().ok_or("`::`")?.end;
    let end = cursor.before().map_or(module_end, |semicolon| semicolon.end);
    let named = |token: &Token| (cursor.text_of(*token).to_owned(), token.span());
    Ok(Import {
        span: start.start..end,
        module: path.iter().map(|token| cursor.text_of(*token).to_owned()).collect(),
        module_span: package.start..module_end,
        items: items.iter().map(named).collect(),
    })
}

/// The items up to the closing brace; a comma may follow the last.
fn list(cursor: &mut Cursor) -> Result<Vec<Token>, &'static str> {
    let mut items = vec![cursor.word().ok_or("a name")?];
    while cursor.symbol('}').is_none() {
        cursor.symbol(',').ok_or("`,` or `}`")?;
        if let Some(item) = cursor.word() {
            items.push(item);
        } else {
            cursor.symbol('}').ok_or("a name or `}`")?;
            break;
        }
    }
    Ok(items)
}

fn colons(cursor: &mut Cursor) -> Result<(), &'static str> {
    cursor.symbol(':').and_then(|_| cursor.symbol(':')).map(|_| ()).ok_or("`::`")
}
