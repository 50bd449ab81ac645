//! Pipelines as RON describes them.

mod entry;

use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use glam::DVec3;
use voxlume_fault::ron::{Document, Fields, Node};
use voxlume_fault::{Fault, Faults, Source, one_of};
use voxlume_scene::WORLD_LIMIT;

pub(crate) use entry::scales;
pub use entry::{ImageWords, Param, PassEntry, SCALES, Value};

use crate::grid::Extent;
use crate::tracer::RAYS;

/// A pipeline file, read but not yet checked against shaders, formats and a scene.
#[derive(Clone, Debug)]
pub struct Pipeline {
    /// The file.
    pub source: Arc<Source>,
    /// Name of the storage format.
    pub format: Located<String>,
    /// Name of the texel encoding.
    pub encoding: Located<String>,
    /// Name of the tracer of passes that name none: [`RAYS`](crate::RAYS) unless given.
    pub tracer: Located<String>,
    /// Voxels along the grid's longest side.
    pub resolution: Located<u32>,
    /// What space the grid takes.
    pub extent: Extent,
    /// Thin (6) or conservative (26).
    pub separability: Located<String>,
    /// Name of the image that is the result.
    pub output: Located<String>,
    /// The passes, in any order.
    pub passes: Vec<PassEntry>,
}

/// A value and where it stands; an override from outside the file has no place.
#[derive(Clone, Debug, PartialEq)]
pub struct Located<T> {
    /// The value.
    pub value: T,
    /// Bytes in the pipeline's file.
    pub span: Option<Range<usize>>,
}

impl Pipeline {
    /// Reads a pipeline file.
    ///
    /// # Errors
    /// Every fault in its form, with its place.
    pub fn load(path: &Path) -> Result<Pipeline, Faults> {
        Pipeline::parse(&Source::read(path)?)
    }

    /// Reads a pipeline from a text.
    ///
    /// # Errors
    /// Every fault in its form, with its place.
    pub fn parse(source: &Arc<Source>) -> Result<Pipeline, Faults> {
        let document = Document::parse(source)?;
        let mut faults = Faults::default();
        let mut fields = Fields::of(document.root())?;
        let format = located::<String>(&mut fields, "format", &mut faults);
        let encoding = located::<String>(&mut fields, "encoding", &mut faults);
        let tracer = optional_word(&mut fields, "tracer", &mut faults);
        let resolution = located::<u32>(&mut fields, "resolution", &mut faults);
        let extent = match fields.node("grid") {
            Some(node) => faults.gather(extent(node)),
            None => Some(Extent::Cubic),
        };
        let separability = located::<String>(&mut fields, "separability", &mut faults);
        let output = located::<String>(&mut fields, "output", &mut faults);
        let passes = fields
            .required_node("passes", &mut faults)
            .and_then(|node| faults.gather(node.items()))
            .map(|items| items.iter().filter_map(|item| entry::pass_entry(*item, &mut faults)).collect());
        fields.finish(&mut faults);
        let pipeline = (|| {
            Some(Pipeline {
                source: Arc::clone(source),
                format: format?,
                encoding: encoding?,
                tracer: tracer.unwrap_or_else(|| Located { value: RAYS.name.to_owned(), span: None }),
                resolution: resolution?,
                extent: extent?,
                separability: separability?,
                output: output?,
                passes: passes?,
            })
        })();
        match pipeline {
            Some(pipeline) if faults.is_empty() => Ok(pipeline),
            _ => Err(faults),
        }
    }

    /// A fault at a place of this file, or without one for a value from elsewhere.
    pub fn fault(
        &self,
        span: &Option<Range<usize>>,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Fault {
        let fault = Fault::new(message);
        match span {
            Some(span) => fault.at(&self.source, span.clone(), label),
            None => {
                let label = label.into();
                if label.is_empty() { fault } else { fault.note(label) }
            }
        }
    }
}

fn located<T: voxlume_fault::ron::FromRon>(
    fields: &mut Fields<'_>,
    name: &str,
    faults: &mut Faults,
) -> Option<Located<T>> {
    let node = fields.required_node(name, faults)?;
    let value = faults.gather(node.get())?;
    Some(Located { value, span: Some(node.span()) })
}

fn optional_word(fields: &mut Fields<'_>, name: &str, faults: &mut Faults) -> Option<Located<String>> {
    let node = fields.node(name)?;
    Some(Located { value: faults.gather(node.get())?, span: Some(node.span()) })
}

/// `(fit: "cubic")`, `(fit: "bounds")`, or `(min: (x, y, z), max: (x, y, z))`.
fn extent(node: Node<'_>) -> Result<Extent, Faults> {
    const FITS: [&str; 2] = ["cubic", "bounds"];
    let mut faults = Faults::default();
    let mut fields = Fields::of(node)?;
    let fit = fields.node("fit");
    let mut corner = |name: &str, faults: &mut Faults| {
        let node = fields.node(name)?;
        let numbers: Vec<f64> = faults.gather(node.get())?;
        match <[f64; 3]>::try_from(numbers) {
            Ok(corner) if corner.iter().all(|n| n.abs() <= WORLD_LIMIT) => {
                Some((DVec3::from_array(corner), node))
            }
            _ => {
                let label = format!("three numbers within ±{WORLD_LIMIT:e}");
                faults.push(node.fault(format!("`{name}` must be a point"), label));
                None
            }
        }
    };
    let corners = (corner("min", &mut faults), corner("max", &mut faults));
    fields.finish(&mut faults);
    let extent = match (fit, corners) {
        (Some(fit), (None, None)) => match faults.gather(fit.get::<String>()) {
            Some(word) if word == "cubic" => Some(Extent::Cubic),
            Some(word) if word == "bounds" => Some(Extent::Bounds),
            Some(word) => {
                faults.push(fit.fault(format!("unknown fit `{word}`"), one_of(FITS)));
                None
            }
            None => None,
        },
        (None, (Some((low, _)), Some((high, _)))) if low.cmplt(high).all() => Some(Extent::Box(low, high)),
        (None, (Some(_), Some((_, at)))) => {
            faults.push(at.fault("the grid is empty", "each coordinate must be above that of `min`"));
            None
        }
        _ => None,
    };
    match extent {
        Some(extent) if faults.is_empty() => Ok(extent),
        _ if faults.is_empty() => {
            let label = "either `fit: \"cubic\"` or `fit: \"bounds\"`, or both `min` and `max`";
            Err(node.fault("the grid is neither fitted nor given", label).into())
        }
        _ => Err(faults),
    }
}
