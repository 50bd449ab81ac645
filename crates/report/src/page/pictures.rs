//! Pictures within the page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use super::Strip;
use crate::number::short;
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
pub(super) struct Pictures {
    /// `data:` URIs.
    pub(super) list: Vec<String>,
}

impl Pictures {
    fn add(&mut self, png: &[u8]) -> usize {
        let uri = format!("data:image/png;base64,{}", STANDARD.encode(png));
        self.list.iter().position(|known| *known == uri).unwrap_or_else(|| {
            self.list.push(uri);
            self.list.len() - 1
        })
    }

    pub(super) fn script(&mut self, strip: &Strip, row: &Row) -> ScriptStrip {
        ScriptStrip {
            name: row.setting(),
            image: self.add(&strip.image),
            reference: self.add(&strip.reference),
            error: self.add(&strip.error),
            note: format!("red: too bright, blue: too dark, full at {}", short(strip.error_scale)),
        }
    }
}
