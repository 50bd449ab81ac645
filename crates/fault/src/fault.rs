//! One fault, and all the faults of an input.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::SimpleFile;
use codespan_reporting::term;

use crate::Source;

/// Something wrong with what the user gave. Its `Display` is the whole message: several lines where
/// there is a place, no colour, no newline at the end.
#[derive(Clone, Debug)]
pub struct Fault {
    /// What is wrong, in one line.
    pub message: String,
    /// Where, if it is in a text.
    pub place: Option<Place>,
    /// Further lines.
    pub notes: Vec<String>,
}

/// A stretch of a source.
#[derive(Clone, Debug)]
pub struct Place {
    /// The text.
    pub source: Arc<Source>,
    /// Bytes in it; what lies outside the text or within a character is cut when displayed.
    pub span: Range<usize>,
    /// Said beside the caret: what would be valid there.
    pub label: String,
}

impl Fault {
    /// A fault without a place.
    pub fn new(message: impl Into<String>) -> Fault {
        Fault { message: message.into(), place: None, notes: Vec::new() }
    }

    /// The same fault, placed.
    #[must_use]
    pub fn at(mut self, source: &Arc<Source>, span: Range<usize>, label: impl Into<String>) -> Fault {
        self.place = Some(Place { source: Arc::clone(source), span, label: label.into() });
        self
    }

    /// The same fault with one more line.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Fault {
        self.notes.push(note.into());
        self
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let diagnostic = Diagnostic::error().with_message(&self.message).with_notes(self.notes.clone());
        let rendered = match &self.place {
            Some(Place { source, span, label }) => {
                let label = Label::primary((), clamp(&source.text, span)).with_message(label);
                let file = SimpleFile::new(&source.name, &*source.text);
                term::emit_into_string(&term::Config::default(), &file, &diagnostic.with_label(label))
            }
            None => term::emit_into_string(&term::Config::default(), &SimpleFile::new("", ""), &diagnostic),
        };
        let rendered = rendered.map_err(|_| fmt::Error)?;
        let mut lines = rendered.trim_end().lines();
        f.write_str(lines.next().unwrap_or_default().trim_end())?;
        lines.try_for_each(|line| write!(f, "\n{}", line.trim_end()))
    }
}

impl std::error::Error for Fault {}

fn clamp(text: &str, span: &Range<usize>) -> Range<usize> {
    let start = text.floor_char_boundary(span.start);
    start..text.ceil_char_boundary(span.end).max(start)
}

/// Every fault of an input. As an error it is never empty: [`Faults::into_result`] makes it one only
/// when there is a fault in it.
#[derive(Clone, Debug, Default)]
pub struct Faults(Vec<Fault>);

impl Faults {
    /// Adds a fault.
    pub fn push(&mut self, fault: Fault) {
        self.0.push(fault);
    }

    /// Takes the value out of a result, or its faults in.
    pub fn gather<T>(&mut self, result: Result<T, impl Into<Faults>>) -> Option<T> {
        result.map_err(|faults| self.extend(faults.into())).ok()
    }

    /// Whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The faults in the order they were found.
    pub fn iter(&self) -> std::slice::Iter<'_, Fault> {
        self.0.iter()
    }

    /// Sorted by place, as one reads the files; those without a place come first.
    #[must_use]
    pub fn in_order(mut self) -> Faults {
        self.0.sort_by_key(|fault| {
            fault.place.as_ref().map(|place| (place.source.name.clone(), place.span.start))
        });
        self
    }

    /// The faults of an input within another one: `change` says what the reader needs to know of that.
    #[must_use]
    pub fn map(self, change: impl Fn(Fault) -> Fault) -> Faults {
        Faults(self.0.into_iter().map(change).collect())
    }

    /// `value` where nothing is wrong.
    ///
    /// # Errors
    /// These faults, if there is any.
    pub fn into_result<T>(self, value: T) -> Result<T, Faults> {
        if self.0.is_empty() { Ok(value) } else { Err(self) }
    }
}

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Faults {
        Faults(vec![fault])
    }
}

impl Extend<Fault> for Faults {
    fn extend<I: IntoIterator<Item = Fault>>(&mut self, faults: I) {
        self.0.extend(faults);
    }
}

impl IntoIterator for Faults {
    type Item = Fault;
    type IntoIter = std::vec::IntoIter<Fault>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a> IntoIterator for &'a Faults {
    type Item = &'a Fault;
    type IntoIter = std::slice::Iter<'a, Fault>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl fmt::Display for Faults {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, fault) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str("\n\n")?;
            }
            fault.fmt(f)?;
        }
        Ok(())
    }
}

impl std::error::Error for Faults {}
