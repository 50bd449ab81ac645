//! Tracers: how effects and voxels find out what lies in a direction.

use voxlume_fault::Faults;

use crate::entries::sorts;
use crate::pass::{Kinds, Sort};
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
    /// What it looks at. An effect that reads a volume reads these instead: the volume itself, or what the volume is made of.
    pub reads: &'static [Sort],
    /// Whether it samples a volume's textures; if not, it reads of a volume only what every side of a voxel sends, and the
    /// textures are not made for it.
    pub samples: bool,
}

impl Tracer {
    /// Whether it asks the voxels themselves what is visible.
    pub fn walks(&self) -> bool {
        self.reads.contains(&Sort::VOXELS)
    }
}

/// Cones through the volume's levels (RAU §6.1, DVS §4).
pub const CONES: Tracer = Tracer {
    name: "cones",
    summary: "cones through the volume's levels, as wide as what they gather",
    modules: "tracer/cones",
    reads: &[Sort::VOLUME],
    samples: true,
};

/// Rays through the bitmask (VGI §4).
pub const RAYS: Tracer = Tracer {
    name: "rays",
    summary: "rays through the occupancy bitmask to the first surface, whose own voxel says what it sends",
    modules: "tracer/rays",
    reads: &[Sort::VOXELS, Sort::VOLUME],
    samples: false,
};

/// The tracers to choose from.
#[derive(Clone, Debug)]
pub struct Tracers(Vec<Tracer>);

impl Tracers {
    /// The tracers that come with Voxlume; the first is the default.
    pub fn builtin() -> Tracers {
        Tracers(vec![RAYS, CONES])
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
        self.get(&word.value).unwrap_or(&RAYS)
    }
}

/// Finds unknown words, and lets effects read what their tracers do.
pub(crate) fn resolve(pipeline: &mut Pipeline, kinds: &Kinds, tracers: &Tracers, faults: &mut Faults) {
    let words = std::iter::once(&pipeline.tracer)
        .chain(pipeline.passes.iter().filter_map(|entry| entry.tracer.as_ref()))
        .filter(|word| tracers.get(&word.value).is_none());
    let known: Vec<&str> = tracers.iter().map(|tracer| tracer.name).collect();
    faults.extend(words.map(|word| unknown(pipeline, "tracer", word, &known)));
    let sorts = sorts(pipeline, kinds);
    let sort = |name: &str| sorts.get(name).copied();
    let whole = pipeline.clone();
    for entry in pipeline.passes.iter_mut().filter(|entry| kinds.get(&entry.run.value).is_none()) {
        let is_volume = |name: &Located<String>| sort(&name.value) == Some(Sort::VOLUME);
        let Some(place) = entry.reads.iter().position(is_volume) else { continue };
        let volume = entry.reads.remove(place);
        // The volume is made by the pass that writes it, of what that pass reads.
        let maker =
            whole.passes.iter().find(|maker| maker.writes.iter().any(|name| name.value == volume.value));
        for wanted in tracers.of(&whole, entry).reads {
            let of_maker = maker.into_iter().flat_map(|maker| &maker.reads);
            let mut names = std::iter::once(&volume).chain(of_maker);
            let Some(name) = names.find(|name| sort(&name.value) == Some(*wanted)) else { continue };
            if !entry.reads.iter().any(|read| read.value == name.value) {
                entry.reads.push(Located { value: name.value.clone(), span: volume.span.clone() });
            }
        }
    }
}
