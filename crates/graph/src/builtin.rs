//! The pipelines that come with Voxlume.

use voxlume_fault::{Fault, Faults, Source, suggest};

use crate::Pipeline;

/// Name, file and text of every pipeline that comes with Voxlume; the first is the default.
pub const PIPELINES: [(&str, &str, &str); 2] = [
    ("gi", "pipelines/gi.ron", include_str!("../pipelines/gi.ron")),
    ("rauwendaal", "pipelines/rauwendaal.ron", include_str!("../pipelines/rauwendaal.ron")),
];

impl Pipeline {
    /// The pipeline of that name that comes with Voxlume: `gi`, `rauwendaal`.
    ///
    /// # Errors
    /// There is none of that name.
    pub fn builtin(name: &str) -> Result<Pipeline, Faults> {
        let Some((_, file, text)) = PIPELINES.iter().find(|(known, ..)| *known == name) else {
            let names = PIPELINES.iter().map(|(known, ..)| *known);
            return Err(Fault::new(format!("unknown pipeline `{name}`")).note(suggest(name, names)).into());
        };
        Pipeline::parse(&Source::new(*file, *text))
    }
}
