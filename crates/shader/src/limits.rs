//! Limits on what is handed to naga and to drivers, whose compilers recurse along these; a stack is finite.
//! Measured: naga's recursion takes four times as much and more within the 2 MiB of a thread.

use std::sync::Arc;

use voxlume_fault::{Fault, Source};

use crate::token::{Cursor, Kind};

/// Tokens of an expression, of which each operator may be a level.
const EXPRESSION: usize = 2000;
/// `else` in a function, of which each is a level.
const ELSES: usize = 250;
/// Declarations linked, of which each may use the next.
pub(crate) const DECLARATIONS: usize = 2000;
/// Resources linked, all in one bind group: WebGPU's `maxBindingsPerBindGroup`.
pub(crate) const RESOURCES: usize = 1000;

/// The first place where a file is over a limit.
pub(crate) fn exceeded(cursor: &Cursor, source: &Arc<Source>) -> Option<Fault> {
    let (mut expression, mut elses) = (0, 0);
    cursor.tokens().iter().find_map(|token| {
        match token.kind {
            Kind::Symbol(';' | '{' | '}' | ',') => expression = 0,
            _ => expression += 1,
        }
        match cursor.text_of(*token) {
            "fn" => elses = 0,
            "else" => elses += 1,
            _ => {}
        }
        let limit = if expression > EXPRESSION {
            format!("more than {EXPRESSION} tokens in one expression")
        } else if elses > ELSES {
            format!("more than {ELSES} `else` in one function")
        } else {
            return None;
        };
        Some(Fault::new("too long to compile safely").at(source, token.span(), limit))
    })
}
