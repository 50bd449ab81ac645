//! Just enough of RON's tokens to tell where values begin and end in a text that `ron` has accepted.

use std::ops::Range;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Token {
    Open,
    Close,
    Comma,
    Colon,
    /// A string, character, number or word.
    Leaf,
}

/// Tokens of `text` from byte `at` on, without white space and comments.
pub(super) struct Lexer<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Lexer<'a> {
    pub(super) fn new(text: &'a str, at: usize) -> Self {
        Lexer { text, at }
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn skip_trivia(&mut self) {
        loop {
            let rest = self.rest();
            self.at += if rest.starts_with("//") {
                rest.find('\n').unwrap_or(rest.len())
            } else if rest.starts_with("/*") {
                block_comment(rest)
            } else {
                match rest.chars().next() {
                    // The direction marks are white space to `ron`, not to Unicode's property.
                    Some(c) if c.is_whitespace() || matches!(c, '\u{200e}' | '\u{200f}') => c.len_utf8(),
                    _ => return,
                }
            }
        }
    }
}

impl Iterator for Lexer<'_> {
    type Item = (Token, Range<usize>);

    fn next(&mut self) -> Option<Self::Item> {
        self.skip_trivia();
        let rest = self.rest();
        let token = match rest.chars().next()? {
            '(' | '[' | '{' => Token::Open,
            ')' | ']' | '}' => Token::Close,
            ',' => Token::Comma,
            ':' => Token::Colon,
            _ => Token::Leaf,
        };
        let start = self.at;
        self.at += if token == Token::Leaf { leaf(rest) } else { 1 };
        Some((token, start..self.at))
    }
}

/// Length of the nested comment that `text` begins with.
fn block_comment(text: &str) -> usize {
    let (mut depth, mut at) = (0, 0);
    while at < text.len() {
        let pair = &text.as_bytes()[at..(at + 2).min(text.len())];
        match pair {
            b"/*" => depth += 1,
            b"*/" => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            break;
        }
    }
    at
}

/// Length of the string, character, number or word that `text` begins with; at least 1.
fn leaf(text: &str) -> usize {
    let unprefixed = text.strip_prefix('b').unwrap_or(text);
    let prefix = text.len() - unprefixed.len();
    if let Some(raw) = unprefixed.strip_prefix('r') {
        let hashes = raw.len() - raw.trim_start_matches('#').len();
        if raw[hashes..].starts_with('"') {
            let close = format!("\"{}", &raw[..hashes]);
            let body = prefix + 1 + hashes + 1;
            return text[body..].find(&close).map_or(text.len(), |end| body + end + close.len());
        }
    }
    match unprefixed.chars().next() {
        Some(quote @ ('"' | '\'')) => prefix + quoted(unprefixed, quote),
        _ => {
            let ends = |c: char| c.is_whitespace() || "()[]{},:\"'/".contains(c);
            // A stray first character still has to be passed.
            let first = text.chars().next().map_or(0, char::len_utf8);
            text[first..].find(ends).map_or(text.len(), |end| first + end)
        }
    }
}

/// Length of the literal that `text` begins with, quotes included.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if c == quote => return at + 1,
            _ => {}
        }
    }
    text.len()
}
