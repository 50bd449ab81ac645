//! Pictures within the page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use super::Strip;
use crate::number::short;
use crate::picture::jpeg;
use crate::results::Row;

/// A strip for the page's script: pictures by their place in the list of all.
#[derive(Serialize)]
pub(super) struct ScriptStrip {
    name: String,
    image: usize,
    reference: usize,
    error: usize,
    note: String,
}

/// Every different picture once: many rows share a reference.
#[derive(Default)]
pub(super) struct Pictures<'a> {
    files: Vec<&'a [u8]>,
}

/// Bytes of PNG files up to which a page has them as they are; beyond, it has JPEG files.
const MOST_PNG: usize = 3 << 20;

impl<'a> Pictures<'a> {
    fn add(&mut self, png: &'a [u8]) -> usize {
        self.files.iter().position(|known| *known == png).unwrap_or_else(|| {
            self.files.push(png);
            self.files.len() - 1
        })
    }

    /// Whether they are smaller than what was rendered would need.
    pub(super) fn are_reduced(&self) -> bool {
        self.files.iter().map(|file| file.len()).sum::<usize>() > MOST_PNG
    }

    /// `data:` URIs. A file that is no PNG stays as it is.
    pub(super) fn uris(&self) -> Vec<String> {
        let reduced = self.are_reduced();
        let uri = |png: &&[u8]| match jpeg(png) {
            Ok(file) if reduced => format!("data:image/jpeg;base64,{}", STANDARD.encode(file)),
            _ => format!("data:image/png;base64,{}", STANDARD.encode(png)),
        };
        self.files.iter().map(uri).collect()
    }

    pub(super) fn script(&mut self, strip: &'a Strip, row: &Row) -> ScriptStrip {
        ScriptStrip {
            name: row.setting(),
            image: self.add(&strip.image),
            reference: self.add(&strip.reference),
            error: self.add(&strip.error),
            note: format!("red: too bright, blue: too dark, full at {}", short(strip.error_scale)),
        }
    }
}
