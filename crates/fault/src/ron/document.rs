//! A checked text.

use std::ops::Range;
use std::sync::Arc;

use ron::Options;
use ron::extensions::Extensions;
use serde::de::IgnoredAny;

use super::lexer::{Lexer, Token};
use super::node::Node;
use crate::{Fault, Source};

/// A text that is RON. Options need no `Some(...)`, whatever the text enables.
#[derive(Clone, Debug)]
pub struct Document {
    source: Arc<Source>,
    root: Range<usize>,
}

impl Document {
    /// Checks the syntax of the whole text.
    ///
    /// # Errors
    /// The first error of syntax; after it nothing else can be told.
    pub fn parse(source: &Arc<Source>) -> Result<Document, Fault> {
        let text = &*source.text;
        options().from_str::<IgnoredAny>(text).map_err(|error| syntax(source, 0..text.len(), &error))?;
        let mut start = 0;
        // `#![enable(...)]` comes before the value.
        while let Some((Token::Leaf, word)) = Lexer::new(text, start).next()
            && text[word.clone()].starts_with('#')
        {
            start = value_end(text, word.end);
        }
        let root = span_of(Lexer::new(text, start)).unwrap_or(start..text.len());
        Ok(Document { source: Arc::clone(source), root })
    }

    /// The value.
    pub fn root(&self) -> Node<'_> {
        Node::new(&self.source, self.root.clone())
    }
}

pub(super) fn options() -> Options {
    Options::default().with_default_extension(Extensions::IMPLICIT_SOME)
}

fn span_of(mut tokens: Lexer<'_>) -> Option<Range<usize>> {
    let (_, first) = tokens.next()?;
    Some(first.start..tokens.last().map_or(first.end, |(_, last)| last.end))
}

/// End of the bracketed value that begins at or after `at`.
fn value_end(text: &str, at: usize) -> usize {
    let mut depth = 0;
    for (token, span) in Lexer::new(text, at) {
        match token {
            Token::Open => depth += 1,
            Token::Close => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return span.end;
        }
    }
    text.len()
}

/// `ron`'s error about the bytes `within` of the source, placed in the source.
pub(super) fn syntax(source: &Arc<Source>, within: Range<usize>, error: &ron::error::SpannedError) -> Fault {
    let text = &source.text[within.clone()];
    let byte = |position: ron::error::Position| {
        let mut lines = text.split_inclusive('\n');
        let before: usize = lines.by_ref().take(position.line.saturating_sub(1)).map(str::len).sum();
        let line = lines.next().unwrap_or_default();
        let column = position.col.saturating_sub(1);
        within.start + before + line.char_indices().nth(column).map_or(line.len(), |(at, _)| at)
    };
    let (start, end) = (byte(error.span.start), byte(error.span.end));
    // Over a line's end, the parser's last step was white space: what it stumbled over is behind.
    let start = if source.text[start..end].contains('\n') { end } else { start };
    let message = match &error.code {
        ron::Error::ExceededRecursionLimit => "nested too deeply".to_owned(),
        code => {
            let message = code.to_string();
            let mut letters = message.chars();
            letters.next().map(|first| first.to_lowercase().chain(letters).collect()).unwrap_or_default()
        }
    };
    Fault::new(message).at(source, start..end.max(source.text.ceil_char_boundary(start + 1)), "")
}
