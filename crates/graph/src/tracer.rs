//! Tracers: how effects and voxels find out what lies in a direction.

use voxlume_fault::Faults;

use crate::kind::Kind;
use crate::pipeline::{Located, PassEntry, Pipeline};
use crate::planner::unknown;

/// A way to trace the scene. Its WGSL fulfils [`TRACER`](voxlume_shader::TRACER); what it lets a pass choose is its
/// `struct TraceParams`, bound as `trace_params`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tracer {
    /// The word in RON and on the command line.
    pub name: &'static str,
    /// What it does, in a sentence.
    pub summary: &'static str,
    /// Path of the folder of its WGSL modules in the shader library, such as `tracer/cones`.
    pub modules: &'static str,
    /// The resources of the graph that it looks at. `volume` in the `reads` of an effect stands for them.
    pub reads: &'static [&'static str],
}

/// Cones through the volume's levels (RAU §6.1, DVS §4).
pub const CONES: Tracer = Tracer {
    name: "cones",
    summary: "cones through the volume's levels, as wide as what they gather",
    modules: "tracer/cones",
    reads: &["volume"],
};

/// The tracers to choose from.
#[derive(Clone, Debug)]
pub struct Tracers(Vec<Tracer>);

impl Tracers {
    /// The tracers that come with Voxlume; the first is the default.
    pub fn builtin() -> Tracers {
        Tracers(vec![CONES])
    }

    /// Adds a tracer; one of the same name gives way.
    pub fn add(&mut self, tracer: Tracer) {
        self.0.retain(|other| other.name != tracer.name);
        self.0.push(tracer);
    }

    /// The tracer called `name`.
    pub fn get(&self, name: &str) -> Option<&Tracer> {
        self.iter().find(|tracer| tracer.name == name)
    }

    /// All of them, in the order added.
    pub fn iter(&self) -> impl Iterator<Item = &Tracer> {
        self.0.iter()
    }

    /// The tracer of a pass: its own word's, or else the pipeline's. An unknown word stands for the default.
    pub(crate) fn of(&self, pipeline: &Pipeline, entry: &PassEntry) -> &Tracer {
        let word = entry.tracer.as_ref().unwrap_or(&pipeline.tracer);
        self.get(&word.value).unwrap_or(&CONES)
    }
}

/// Finds unknown words, and lets effects read what their tracers do.
pub(crate) fn resolve(pipeline: &mut Pipeline, tracers: &Tracers, faults: &mut Faults) {
    let words = std::iter::once(&pipeline.tracer)
        .chain(pipeline.passes.iter().filter_map(|entry| entry.tracer.as_ref()))
        .filter(|word| tracers.get(&word.value).is_none());
    let known: Vec<&str> = tracers.iter().map(|tracer| tracer.name).collect();
    faults.extend(words.map(|word| unknown(pipeline, "tracer", word, &known)));
    let reads: Vec<_> = pipeline.passes.iter().map(|entry| tracers.of(pipeline, entry).reads).collect();
    for (entry, reads) in pipeline.passes.iter_mut().zip(reads) {
        let is_effect = Kind::get(&entry.run.value).is_none();
        let Some(place) = entry.reads.iter().position(|name| name.value == "volume").filter(|_| is_effect)
        else {
            continue;
        };
        let volume = entry.reads.remove(place);
        for name in reads {
            if !entry.reads.iter().any(|read| read.value == *name) {
                entry.reads.push(Located { value: (*name).to_owned(), span: volume.span.clone() });
            }
        }
    }
}
