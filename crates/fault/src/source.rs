//! A file that a user wrote.

use std::fmt;
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::sync::Arc;

use crate::Fault;

/// Bytes that [`Source::read`] accepts at most, 16 MiB.
pub const SOURCE_LIMIT: u64 = 16 << 20;

/// A text with the name that messages give it.
#[derive(Clone)]
pub struct Source {
    /// The path as the user wrote it, or what else the text is known by.
    pub name: String,
    /// The whole text.
    pub text: Arc<str>,
}

impl Source {
    /// A source from a text at hand.
    pub fn new(name: impl Into<String>, text: impl Into<Arc<str>>) -> Arc<Source> {
        Arc::new(Source { name: name.into(), text: text.into() })
    }

    /// Reads a file of UTF-8.
    ///
    /// # Errors
    /// A fault that names the path: the file is missing or cannot be read, is larger than
    /// [`SOURCE_LIMIT`], or is not UTF-8.
    pub fn read(path: &Path) -> Result<Arc<Source>, Fault> {
        let name = path.display().to_string();
        let cannot = |why: String| Fault::new(format!("cannot read `{name}`: {why}"));
        let file = File::open(path).map_err(|e| match e.kind() {
            ErrorKind::NotFound => cannot("no such file".into()),
            _ => cannot(e.to_string()),
        })?;
        let mut bytes = Vec::new();
        // One byte more than allowed tells a file that is too large, whatever its length claims.
        file.take(SOURCE_LIMIT + 1).read_to_end(&mut bytes).map_err(|e| cannot(e.to_string()))?;
        if bytes.len() as u64 > SOURCE_LIMIT {
            return Err(cannot(format!("larger than {} MiB", SOURCE_LIMIT >> 20)));
        }
        let text = String::from_utf8(bytes)
            .map_err(|e| cannot(format!("not UTF-8 at byte {}", e.utf8_error().valid_up_to())))?;
        Ok(Source::new(name, text))
    }
}

impl fmt::Debug for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Source({}, {} bytes)", self.name, self.text.len())
    }
}
