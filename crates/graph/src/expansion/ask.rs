//! What a kind of pass asks of an entry, its parameters and the scene.

use crate::bundle::Bundle;
use crate::expansion::Expansion;
use crate::facts::{Emission, SceneFacts};
use crate::grid::Grid;
use crate::live::scale_of;
use crate::pass::Sort;
use crate::pipeline::{Located, PassEntry};
use crate::plan::Target;
use crate::storage::Storage;
use crate::tracer::Tracer;

impl<'c, 'a> Expansion<'c, 'a> {
    /// The entry.
    pub fn entry(&self) -> &'a PassEntry {
        self.entry
    }

    /// What the image's size is divided by where the entry's effect gathers in this scene.
    pub fn scale(&self) -> u32 {
        scale_of(self.entry, self.context.facts, self.context.emission)
    }

    /// What the scene has.
    pub fn facts(&self) -> &'a SceneFacts {
        self.context.facts
    }

    /// Width and height of the screen in pixels.
    pub fn screen(&self) -> [u32; 2] {
        self.context.screen
    }

    /// Lights of all kinds.
    pub fn light_count(&self) -> u32 {
        self.context.light_count()
    }

    /// How emission reaches others.
    pub fn emission(&self) -> Emission {
        self.context.emission
    }

    /// Whether voxels hold emission.
    pub fn voxel_emission(&self) -> bool {
        self.context.voxel_emission()
    }

    /// A parameter of the kind itself, as one of its words. A missing one is a fault.
    pub fn word(&mut self, name: &str) -> Option<&'static str> {
        self.params.word(self.kind, name, &mut self.context.faults)
    }

    /// A word, or the default where the file gives none.
    pub fn word_or(&mut self, name: &str, default: &'static str) -> Option<&'static str> {
        if self.gives(name) { self.word(name) } else { Some(default) }
    }

    /// A number, or the default where the file gives none.
    pub fn number_or(&mut self, name: &str, default: f64) -> Option<f64> {
        self.params.number_or(self.kind, name, default, &mut self.context.faults)
    }

    /// A whole number. A missing one is a fault.
    pub fn whole(&mut self, name: &str) -> Option<u32> {
        self.params.whole(self.kind, name, &mut self.context.faults)
    }

    /// A point, if the file gives it.
    pub fn point(&mut self, name: &str) -> Option<[f64; 3]> {
        self.params.point(self.kind, name, &mut self.context.faults)
    }

    /// Whether the file gives a parameter, which counts as read then.
    pub fn gives(&mut self, name: &str) -> bool {
        self.params.gives(name)
    }

    /// Refuses a parameter's value that was read, for what else is known.
    pub fn refuse(&mut self, name: &str, label: &str) {
        self.params.refuse(name, label, &mut self.context.faults);
    }

    /// What a port of the kind reads; nothing if the entry doesn't read it or nothing makes it.
    pub fn input(&mut self, port: &str) -> Option<Bundle> {
        let name = self.context.read_of(self.entry, self.kind, port)?.to_owned();
        self.used.insert(name.clone());
        self.context.bundles.get(&name).cloned()
    }

    /// The name that the entry gives to what it makes.
    pub fn written(&self) -> String {
        self.entry.writes.first().map(|name| name.value.clone()).unwrap_or_default()
    }

    /// The name of what the entry changes.
    pub fn updated(&mut self) -> String {
        let name = self.entry.updates.first().map(|name| name.value.clone()).unwrap_or_default();
        self.used.insert(name.clone());
        name
    }

    /// Whether an image is the result of the pipeline.
    pub fn is_output(&self, image: &str) -> bool {
        self.context.pipeline.output.value == image
    }

    /// The grid of the voxels that it makes or reads, or the pipeline's.
    pub fn grid(&self) -> &Grid {
        &self.context.grids[self.grid_index()]
    }

    fn grid_index(&self) -> usize {
        let of_bundle = || self.bundles().find_map(Bundle::grid);
        self.grid.or_else(of_bundle).unwrap_or(0)
    }

    /// The grid's values as shaders read them.
    pub fn grid_bundle(&mut self) -> Bundle {
        let index = self.grid_index();
        let mut bundle = Bundle::of("grid", Target::Resource(self.context.grid_resource(index)));
        bundle.set_grid(index);
        bundle
    }

    /// The grid that the entry's parameters describe, or the pipeline's.
    pub(crate) fn begin_grid(&mut self) -> Option<()> {
        let corners = (self.point("min"), self.point("max"));
        let resolution = if self.gives("resolution") { Some(self.whole("resolution")?) } else { None };
        self.grid = Some(self.context.own_grid(resolution, corners).unwrap_or_else(|name| {
            self.refuse(name, "a corner needs the other one, below it in x, y and z, and `resolution`");
            0
        }));
        Some(())
    }

    /// The bundles that the entry names.
    pub(super) fn bundles(&self) -> impl Iterator<Item = &Bundle> {
        let names = self.entry.reads.iter().chain(&self.entry.updates).chain(&self.entry.writes);
        names.filter_map(|name| self.context.bundles.get(&name.value))
    }

    /// What a shader variable stands for in this pass.
    pub fn variable(&self, name: &str) -> Option<Target> {
        self.bundles().find_map(|bundle| bundle.part(name)).cloned()
    }

    /// Whether a pass that is planned samples the textures of a volume, itself or through its tracer.
    pub(crate) fn is_sampled(&self, volume: &str) -> bool {
        let context = &*self.context;
        let mut planned = context.pipeline.passes.iter().filter(|entry| context.is_live(entry));
        planned.any(|entry| {
            let (kind, tracer) = (context.kinds.of(entry), context.tracers.of(context.pipeline, entry));
            let unread = kind.unread(entry, tracer).iter();
            let mut unread = unread.filter_map(|unread| context.read_of(entry, kind, unread.port));
            let mut named = entry.reads.iter().chain(&entry.updates);
            let samples = if kind.traces() { tracer.samples || context.uses_format(entry) } else { true };
            samples && named.any(|name| name.value == volume) && !unread.any(|name| name == volume)
        })
    }

    /// The largest scale at which planned effects take means over pixels; `None` if none does.
    pub(crate) fn coarsest_mean(&self) -> Option<u32> {
        let context = &*self.context;
        let planned = context.pipeline.passes.iter().filter(|entry| context.is_live(entry));
        let scales = planned.map(|entry| (entry, scale_of(entry, context.facts, context.emission)));
        scales.filter(|(entry, scale)| entry.interleave > 1 || *scale > 1).map(|(_, scale)| scale).max()
    }

    /// The tracer of the entry.
    pub fn tracer(&self) -> &'a Tracer {
        self.tracer
    }

    /// A name in the graph whose resources this pass may use before the pass that fills them: that of the first of this
    /// sort which is made from the same voxels, or one of its own.
    pub fn borrowed(&self, sort: Sort) -> String {
        let voxels = |entry: &'a PassEntry| {
            let of_sort =
                |name: &&Located<String>| self.context.sorts.get(&name.value) == Some(&Sort::VOXELS);
            entry.reads.iter().find(of_sort).map(|name| name.value.as_str())
        };
        let made = self.context.pipeline.passes.iter().find(|other| {
            other.name != self.entry.name
                && self.context.kinds.of(other).writes().iter().any(|port| port.sort == sort)
                && self.context.is_live(other)
                && voxels(other) == voxels(self.entry)
        });
        let made = made.and_then(|other| other.writes.first()).map(|name| name.value.clone());
        made.unwrap_or_else(|| format!("{}.{}", self.entry.name, sort.name))
    }

    /// The format and encoding of a volume of the graph: those that the pass which writes it says, or else the pipeline.
    pub(crate) fn storage_of(&mut self, volume: &str) -> Option<Storage<'a>> {
        let makes = |entry: &&PassEntry| entry.writes.iter().any(|write| write.value == volume);
        let maker = self.context.pipeline.passes.iter().find(makes);
        let [format, encoding] = ["format", "encoding"].map(|word| maker.and_then(|maker| maker.word(word)));
        self.context.storage(format, encoding)
    }
}
