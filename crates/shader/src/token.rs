//! WGSL cut into tokens, as far as linking needs to tell them apart.

use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// An identifier or keyword.
    Word,
    /// A number, exponent sign excluded.
    Number,
    /// One character of an operator or separator.
    Symbol(char),
}

/// A token and where it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Token {
    pub kind: Kind,
    pub start: usize,
    pub end: usize,
}

impl Token {
    pub fn span(self) -> Range<usize> {
        self.start..self.end
    }
}

/// A walk over the tokens of a text; comments are passed over, `///` lines kept aside.
pub(crate) struct Cursor<'a> {
    pub text: &'a str,
    tokens: Vec<Token>,
    docs: Vec<Range<usize>>,
    at: usize,
}

impl<'a> Cursor<'a> {
    pub fn new(text: &'a str) -> Cursor<'a> {
        let (tokens, docs) = tokens(text);
        Cursor { text, tokens, docs, at: 0 }
    }

    pub fn peek(&self) -> Option<Token> {
        self.tokens.get(self.at).copied()
    }

    pub fn next(&mut self) -> Option<Token> {
        let token = self.peek()?;
        self.at += 1;
        Some(token)
    }

    pub fn text_of(&self, token: Token) -> &'a str {
        &self.text[token.span()]
    }

    /// The next token if it is this symbol.
    pub fn symbol(&mut self, symbol: char) -> Option<Token> {
        self.peek().filter(|token| token.kind == Kind::Symbol(symbol)).inspect(|_| self.at += 1)
    }

    /// The next token if it is a word.
    pub fn word(&mut self) -> Option<Token> {
        self.peek().filter(|token| token.kind == Kind::Word).inspect(|_| self.at += 1)
    }

    /// Goes past the next `symbol`; where the text ended up.
    pub fn skip_past(&mut self, symbol: char) -> usize {
        while let Some(token) = self.next() {
            if token.kind == Kind::Symbol(symbol) {
                return token.end;
            }
        }
        self.text.len()
    }

    /// The span of the next token, or the end of the text.
    pub fn here(&self) -> Range<usize> {
        self.peek().map_or(self.text.len()..self.text.len(), Token::span)
    }

    /// The token before the next one.
    pub fn before(&self) -> Option<Token> {
        self.at.checked_sub(1).map(|before| self.tokens[before])
    }

    /// The tokens of the whole text.
    pub fn tokens(&self) -> &[Token] {
        &self.tokens
    }

    /// The `///` lines between the token before the next one and the next one, without their slashes.
    pub fn docs_here(&self) -> String {
        let after = self.before().map_or(0, |token| token.end);
        let first = self.docs.partition_point(|doc| doc.start < after);
        let lines = self.docs[first..].iter().take_while(|doc| doc.start < self.here().start);
        lines.map(|doc| self.text[doc.clone()].trim()).collect::<Vec<_>>().join("\n")
    }
}

fn tokens(text: &str) -> (Vec<Token>, Vec<Range<usize>>) {
    let (mut tokens, mut docs) = (Vec::new(), Vec::new());
    let mut start = 0;
    while let Some(first) = text[start..].chars().next() {
        let rest = &text[start..];
        let mut end = start + first.len_utf8();
        if rest.starts_with("//") {
            end = start + rest.find(line_break).unwrap_or(rest.len());
            if rest.starts_with("///") {
                docs.push(start + 3..end);
            }
        } else if rest.starts_with("/*") {
            end = start + block_comment(rest);
        } else if first.is_alphabetic() || first == '_' {
            end = start + rest.find(|c: char| !is_word(c)).unwrap_or(rest.len());
            tokens.push(Token { kind: Kind::Word, start, end });
        } else if first.is_ascii_digit() {
            end = start + rest.find(|c: char| !(is_word(c) || c == '.')).unwrap_or(rest.len());
            tokens.push(Token { kind: Kind::Number, start, end });
        } else if !first.is_whitespace() {
            tokens.push(Token { kind: Kind::Symbol(first), start, end });
        }
        start = end;
    }
    (tokens, docs)
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The line breaks of WGSL, which are more than `\n`.
fn line_break(c: char) -> bool {
    matches!(c, '\n' | '\u{b}' | '\u{c}' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// The length of the comment that `text` starts with; these nest.
fn block_comment(text: &str) -> usize {
    let (mut depth, mut at) = (0usize, 0);
    while let Some(c) = text[at..].chars().next() {
        if text[at..].starts_with("/*") {
            depth += 1;
            at += 2;
        } else if text[at..].starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += c.len_utf8();
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        let mut cursor = Cursor::new(text);
        std::iter::from_fn(|| cursor.next().map(|token| cursor.text_of(token))).collect()
    }

    #[test]
    fn comments_are_passed_over_and_nest() {
        assert_eq!(words("a // b\nc /* d /* e */ f */ g /*/ h */ i"), ["a", "c", "g", "i"]);
        assert_eq!(words("a /* b"), ["a"]);
    }

    #[test]
    fn numbers_hold_no_words() {
        assert_eq!(
            words("1e-5f+.5f 0x1p3 vec3f(1.0f)"),
            ["1e", "-", "5f", "+", ".", "5f", "0x1p3", "vec3f", "(", "1.0f", ")"]
        );
    }

    #[test]
    fn spans_are_bytes() {
        let text = "é // ü\n²ß";
        assert_eq!(words(text), ["é", "²", "ß"]);
    }

    #[test]
    fn doc_lines_belong_to_what_follows() {
        let mut cursor = Cursor::new("/// one\n a, /// two\n /// three \n b");
        assert_eq!(cursor.docs_here(), "one");
        cursor.skip_past(',');
        assert_eq!(cursor.docs_here(), "two\nthree");
        cursor.next();
        assert_eq!(cursor.docs_here(), "");
    }
}
