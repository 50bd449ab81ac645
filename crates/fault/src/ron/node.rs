//! Values with their places.

use std::ops::Range;
use std::sync::Arc;

use serde::de::DeserializeOwned;

use super::document::{options, syntax};
use super::lexer::{Lexer, Token};
use super::read::FromRon;
use crate::{Fault, Faults, Source, suggest};

/// A value in a [`Document`](super::Document).
#[derive(Clone, Copy, Debug)]
pub struct Node<'a> {
    source: &'a Arc<Source>,
    start: usize,
    end: usize,
}

/// `name: value`.
#[derive(Clone, Debug)]
pub struct Field<'a> {
    /// The name, without a raw identifier's `r#`.
    pub name: &'a str,
    /// Bytes of the name.
    pub span: Range<usize>,
    /// The value.
    pub value: Node<'a>,
}

impl<'a> Node<'a> {
    pub(super) fn new(source: &'a Arc<Source>, span: Range<usize>) -> Node<'a> {
        Node { source, start: span.start, end: span.end }
    }

    /// The source it lies in.
    pub fn source(&self) -> &'a Arc<Source> {
        self.source
    }

    /// Its bytes in the source.
    pub fn span(&self) -> Range<usize> {
        self.start..self.end
    }

    /// Its text as written.
    pub fn text(&self) -> &'a str {
        &self.source.text[self.start..self.end]
    }

    /// Where a fault about the whole value points: its name, else its bracket; a leaf's every byte.
    pub fn head(&self) -> Range<usize> {
        self.tokens().next().map_or(self.span(), |(_, span)| span)
    }

    /// `(`, `[` or `{`; `None` for a leaf: a word, number, string or character.
    pub fn delimiter(&self) -> Option<char> {
        let at = self.tokens().take(2).find(|(token, _)| *token == Token::Open)?.1.start;
        self.source.text[at..].chars().next()
    }

    /// `Name` in `Name(...)` or alone; `None` for anything without one.
    pub fn name(&self) -> Option<&'a str> {
        let (token, span) = self.tokens().next()?;
        let word = &self.source.text[span];
        let named = word.starts_with(|c: char| c.is_alphabetic() || c == '_') && !word.ends_with(['"', '\'']);
        (token == Token::Leaf && named).then(|| word.strip_prefix("r#").unwrap_or(word))
    }

    /// The fields of `(a: 1, b: 2)` or `Name(a: 1)`; none of `()`, `Name()` and `Name`.
    ///
    /// # Errors
    /// It is no struct.
    pub fn fields(&self) -> Result<Vec<Field<'a>>, Fault> {
        let expected = || self.expected("fields `(name: value, ...)`");
        match (self.delimiter(), self.name()) {
            (Some('('), _) => {}
            (None, Some(_)) => return Ok(Vec::new()),
            _ => return Err(expected()),
        }
        self.children()
            .into_iter()
            .map(|(key, value)| {
                let key = key.ok_or_else(expected)?;
                let word = key.text();
                let name = word.strip_prefix("r#").unwrap_or(word);
                Ok(Field { name, span: key.span(), value })
            })
            .collect()
    }

    /// The items of a list `[a, b]` or tuple `(a, b)`.
    ///
    /// # Errors
    /// It is neither.
    pub fn items(&self) -> Result<Vec<Node<'a>>, Fault> {
        let expected = || self.expected("a list `[...]`");
        if !matches!(self.delimiter(), Some('[' | '(')) {
            return Err(expected());
        }
        self.children()
            .into_iter()
            .map(|(key, value)| if key.is_some() { Err(expected()) } else { Ok(value) })
            .collect()
    }

    /// The entries of a map `{a: 1, b: 2}`.
    ///
    /// # Errors
    /// It is no map.
    pub fn entries(&self) -> Result<Vec<(Node<'a>, Node<'a>)>, Fault> {
        let expected = || self.expected("a map `{key: value, ...}`");
        if self.delimiter() != Some('{') {
            return Err(expected());
        }
        self.children().into_iter().map(|(key, value)| Ok((key.ok_or_else(expected)?, value))).collect()
    }

    /// Reads it as a `T`.
    ///
    /// # Errors
    /// Every fault in it.
    pub fn get<T: FromRon>(&self) -> Result<T, Faults> {
        T::from_ron(*self)
    }

    /// Reads it through `serde`; for leaves, as only the first fault comes back.
    ///
    /// # Errors
    /// What `ron` says, placed in the file.
    pub fn deserialize<T: DeserializeOwned>(&self) -> Result<T, Fault> {
        options().from_str(self.text()).map_err(|error| syntax(self.source, self.span(), &error))
    }

    /// Reads a word or string that must be one of `choices`.
    ///
    /// # Errors
    /// Anything else: ``unknown {what} `word` ``, with the choices.
    pub fn choice<'c>(
        &self,
        what: &str,
        choices: impl IntoIterator<Item = &'c str> + Clone,
    ) -> Result<&'c str, Fault> {
        let word = match (self.delimiter(), self.name()) {
            (None, Some(word)) => word.to_owned(),
            _ => self.deserialize::<String>().map_err(|_| self.expected(what))?,
        };
        choices
            .clone()
            .into_iter()
            .find(|choice| *choice == word)
            .ok_or_else(|| self.fault(format!("unknown {what} `{word}`"), suggest(&word, choices)))
    }

    /// A fault that points at it.
    pub fn fault(&self, message: impl Into<String>, label: impl Into<String>) -> Fault {
        Fault::new(message).at(self.source, self.head(), label)
    }

    /// The fault that it should be `expected`, say `a number`, and is something else.
    pub fn expected(&self, expected: &str) -> Fault {
        self.fault(format!("expected {expected}, found {}", self.found()), "")
    }

    fn found(&self) -> String {
        let first = self.tokens().next().map_or("", |(_, span)| &self.source.text[span]);
        match (self.delimiter(), self.name()) {
            (Some('('), Some(name)) => format!("`{name}(...)`"),
            (Some('('), None) => "`(...)`".into(),
            (Some('['), _) => "a list".into(),
            (Some(_), _) => "a map".into(),
            (None, _) if first.ends_with('"') => "a string".into(),
            (None, _) => format!("`{}`", self.text()),
        }
    }

    fn tokens(&self) -> impl Iterator<Item = (Token, Range<usize>)> + use<'a> {
        let end = self.end;
        Lexer::new(&self.source.text, self.start).take_while(move |(_, span)| span.end <= end)
    }

    /// The values directly inside the brackets, each with its key if it has one.
    fn children(&self) -> Vec<(Option<Node<'a>>, Node<'a>)> {
        let node = |span: Range<usize>| Node::new(self.source, span);
        let (mut children, mut key, mut value) = (Vec::new(), None, None::<Range<usize>>);
        let mut depth = 0;
        for (token, span) in self.tokens().skip_while(|(token, _)| *token != Token::Open) {
            match token {
                Token::Close => depth -= 1,
                Token::Colon if depth == 1 => {
                    key = value.take().map(node);
                    continue;
                }
                _ => {}
            }
            let ends = depth == 0 || (depth == 1 && token == Token::Comma);
            if ends {
                children.extend(value.take().map(|span| (key.take(), node(span))));
            } else if depth > 0 {
                value = Some(value.map_or(span.start, |value| value.start)..span.end);
            }
            if token == Token::Open {
                depth += 1;
            }
        }
        children
    }
}
