//! One entry of a pipeline on its way to steps.

pub(crate) mod context;
mod run;

use std::collections::{BTreeMap, BTreeSet};

use voxlume_shader::{Binding, Shader};

pub(crate) use context::{Context, Mounts};
pub use run::{Over, Run};

use crate::bundle::Bundle;
use crate::facts::SceneFacts;
use crate::flow::is_scene;
use crate::grid::Grid;
use crate::params::{Params, words};
use crate::pass::{PassKind, Sort};
use crate::pipeline::{Located, PassEntry};
use crate::plan::{
    Bind, ImageExtent, ImageTexel, LeftOut, Life, ParamSlot, Program, ResourceKind, Step, Target,
};
use crate::storage::Storage;
use crate::tracer::Tracer;

/// Bytes of a `LevelRun` in wgsl/common/grid.wgsl.
pub(crate) const LEVEL_RUN_BYTES: u64 = 32;

/// One entry of a pipeline on its way to steps: what a [`PassKind`] asks and adds to.
#[derive(Debug)]
pub struct Expansion<'c, 'a> {
    context: &'c mut Context<'a>,
    entry: &'a PassEntry,
    kind: &'a dyn PassKind,
    params: Params<'a>,
    steps: Vec<Step>,
    once: Vec<Step>,
    /// The grid that it voxelizes into, in the context's list; else the one of the voxels or volume that it reads.
    grid: Option<usize>,
    used: BTreeSet<String>,
    tracer: &'a Tracer,
    /// Whether a program of it traces.
    traces: bool,
    /// Its parameters, by the struct that has them.
    uniforms: BTreeMap<&'static str, usize>,
    slots: Vec<ParamSlot>,
}

/// What comes of an entry.
pub(crate) struct Expanded {
    /// Steps that have to be done only once, before the others.
    pub once: Vec<Step>,
    pub steps: Vec<Step>,
    pub params: Vec<ParamSlot>,
}

/// What is asked of the entry, its parameters and the scene.
impl<'c, 'a> Expansion<'c, 'a> {
    pub(crate) fn new(context: &'c mut Context<'a>, entry: &'a PassEntry) -> Expansion<'c, 'a> {
        let params = Params::of(context.pipeline, entry);
        let kind = context.kinds.of(entry);
        let tracer = context.tracers.of(context.pipeline, entry);
        Expansion {
            context,
            entry,
            kind,
            params,
            steps: Vec::new(),
            once: Vec::new(),
            grid: None,
            used: BTreeSet::new(),
            tracer,
            traces: false,
            uniforms: BTreeMap::new(),
            slots: Vec::new(),
        }
    }

    /// The entry.
    pub fn entry(&self) -> &'a PassEntry {
        self.entry
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
    fn bundles(&self) -> impl Iterator<Item = &Bundle> {
        let names = self.entry.reads.iter().chain(&self.entry.updates).chain(&self.entry.writes);
        names.filter_map(|name| self.context.bundles.get(&name.value))
    }

    /// What a shader variable stands for in this pass.
    pub fn variable(&self, name: &str) -> Option<Target> {
        self.bundles().find_map(|bundle| bundle.part(name)).cloned()
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

/// What is made.
impl<'c, 'a> Expansion<'c, 'a> {
    /// A buffer or texture, made as `kind` at its first use.
    pub fn resource(&mut self, name: &str, kind: ResourceKind) -> usize {
        self.context.resource(name, kind)
    }

    /// A buffer that passes which share it leave right for each other: see [`Life::Kept`].
    pub fn kept(&mut self, name: &str, kind: ResourceKind) -> usize {
        let resource = self.resource(name, kind);
        self.context.resources[resource].life = Life::Kept;
        resource
    }

    /// The resource called `name`, if there is one.
    pub fn known(&self, name: &str) -> Option<usize> {
        self.context.known(name)
    }

    /// A part of what the entry writes: called as the part alone where the entry writes it under `usual`, the port's own
    /// name, else with the entry's name before it.
    pub fn part(&mut self, usual: &str, part: &str, kind: ResourceKind) -> usize {
        self.part_of(&self.written(), usual, part, kind)
    }

    /// A part of what the graph calls `name`; see [`Expansion::part`].
    pub fn part_of(&mut self, name: &str, usual: &str, part: &str, kind: ResourceKind) -> usize {
        match name == usual {
            true => self.resource(part, kind),
            false => self.resource(&format!("{name}.{part}"), kind),
        }
    }

    /// Says what the name that the entry writes stands for.
    pub fn makes(&mut self, bundle: Bundle) {
        let name = self.written();
        self.context.bundles.insert(name, bundle);
    }

    /// Notes something that is left out for this scene.
    pub fn leaves_out(&mut self, what: &str, why: &str, bytes: u64) {
        self.context.left_out.push(LeftOut { what: what.to_owned(), why: why.to_owned(), bytes });
    }

    /// Notes a buffer with the runs of a grid's levels.
    pub(crate) fn counts_cells(&mut self, levels: usize) {
        self.context.levels.push(levels);
    }

    /// Notes a buffer that counts values which an encoding can't hold.
    pub(crate) fn counts_out_of_range(&mut self, resource: usize) {
        self.context.out_of_range.push(resource);
    }

    /// Fills a buffer with zeroes.
    pub fn clear(&mut self, resource: usize) {
        self.steps.push(Step::Clear(resource));
    }

    /// Copies a buffer to the beginning of another.
    pub fn copy(&mut self, from: usize, to: usize) {
        self.steps.push(Step::Copy { from, to });
    }

    /// Says that buffers sized by the number of occupied cells can be made from here on.
    pub fn counted(&mut self) {
        self.steps.push(Step::Counted);
    }

    /// Says that the steps so far have to be done only once.
    pub fn once(&mut self) {
        self.once.append(&mut self.steps);
    }

    /// A program of a WGSL module; what it is given and over what it runs is said on what this returns.
    pub fn run<'e>(&'e mut self, module: &str) -> Run<'e, 'c, 'a> {
        Run::new(self, module)
    }

    /// Checks an effect's module by itself, so that faults point into it.
    pub(crate) fn checked_effect(&mut self, module: &str) -> Option<()> {
        let mounts = self.mounts(&[], None);
        self.context.effect(module, &mounts)
    }

    /// Reports what the entry names and the pass never used, and parameters that nobody read.
    pub(crate) fn finish(self) -> Expanded {
        for name in &self.entry.reads {
            let unread = self.kind.unread(self.entry).iter().any(|unread| {
                self.context.read_of(self.entry, self.kind, unread.port) == Some(name.value.as_str())
            });
            let made = self.context.bundles.contains_key(name.value.trim_end_matches(LAST));
            // Opacity alone may take less than all that a tracer looks at.
            let sort = self.context.sorts.get(&name.value);
            let traced = self.traces && sort.is_some_and(|sort| self.tracer.reads.contains(sort));
            if made
                && !traced
                && !unread
                && !self.used.contains(&name.value)
                && self.context.faults.is_empty()
            {
                let message = format!("pass `{}` never uses `{}`", self.entry.name, name.value);
                self.context.faults.push(self.context.pipeline.fault(&name.span, message, "read in vain"));
            }
        }
        // Without its shader a pass's parameters are unknown.
        if !self.steps.is_empty() || self.kind.idle(self.entry).is_some() {
            self.params.finish(self.traces, self.context);
            let in_vain = self.entry.tracer.as_ref().filter(|_| !self.traces);
            self.context.faults.extend(in_vain.map(|word| {
                let message = format!("pass `{}` traces nothing", self.entry.name);
                self.context.pipeline.fault(&word.span, message, "a tracer named in vain")
            }));
        }
        Expanded { once: self.once, steps: self.steps, params: self.slots }
    }
}

/// How programs are bound.
impl Expansion<'_, '_> {
    /// The modules that imports below `package::<name>` mean: what a step says, then what the entry's bundles say, then the
    /// pipeline's.
    fn mounts(&self, own: &[(&'static str, String)], with: Option<&Bundle>) -> Mounts {
        let mut mounts: Mounts = own.to_vec();
        let bundles = with.into_iter().chain(self.bundles());
        let theirs = bundles.flat_map(|bundle| bundle.mounts().iter().cloned());
        let theirs = theirs.chain([("tracer", self.tracer.modules.to_owned())]);
        for (name, folder) in theirs.chain(self.context.default_mounts()) {
            if !mounts.iter().any(|(known, _)| *known == name) {
                mounts.push((name, folder));
            }
        }
        mounts
    }

    /// What a variable of a shader is bound to.
    fn target(&mut self, binding: &Binding, shader: usize, with: Option<&Bundle>) -> Option<Target> {
        let name = binding.name.as_str();
        if is_scene(name) {
            return Some(Target::Resource(self.context.resource(name, ResourceKind::Scene)));
        }
        let own = PARAMS.iter().find(|(variable, _)| *variable == name);
        if let Some((variable, structure)) = own {
            return self.uniform(shader, variable, structure).map(Target::Resource);
        }
        if let Some(target) = with.and_then(|bundle| bundle.part(name)) {
            return Some(target.clone());
        }
        if let Some(target) = self.named(name) {
            return Some(target);
        }
        if name == "grid" {
            return self.grid_bundle().part(name).cloned();
        }
        if self.context.is_idle_volume(binding) {
            // What another choice of the format's options would have.
            return Some(Target::Nothing);
        }
        let optional = self.kind.reads().iter().any(|port| port.name == name && port.optional);
        let guard = format!("HAS_{}", name.to_uppercase());
        let guarded = self.context.shaders[shader].overrides().iter().any(|o| o.name == guard);
        let left_out = self.entry.reads.iter().any(|read| {
            let sort = self.context.sorts.get(read.value.trim_end_matches(LAST));
            self.entry.alias(&read.value) == name || sort.is_some_and(|sort| sort.images.contains(&name))
        });
        if optional || guarded || left_out {
            return Some(Target::Nothing);
        }
        // What is not made for a fault of its own is no fault of the reader's.
        let named = self.entry.reads.iter().chain(&self.entry.updates);
        let mut named = named.map(|name| name.value.trim_end_matches(LAST));
        if named.any(|name| !self.context.bundles.contains_key(name)) && !self.context.faults.is_empty() {
            return None;
        }
        let group = self.context.owner_of(name).unwrap_or(name).to_owned();
        let message = format!("pass `{}` uses `{group}` without reading it", self.entry.name);
        let label = format!("its shader's variable `{name}` needs `{group}` in `reads`");
        // A volume is several textures.
        if !self.context.faults.iter().any(|fault| fault.message == message) {
            self.context.faults.push(self.context.pipeline.fault(&self.entry.run.span, message, label));
        }
        None
    }

    /// What a variable is among the entry's own names: a part of what it names, or an image under the name that it has here.
    fn named(&mut self, variable: &str) -> Option<Target> {
        let entry = self.entry;
        for read in entry.reads.iter().chain(&entry.updates).chain(&entry.writes) {
            let (name, last) = match read.value.strip_suffix(LAST) {
                Some(name) => (name, true),
                None => (read.value.as_str(), false),
            };
            let Some(bundle) = self.context.bundles.get(name) else { continue };
            let alias = entry.alias(&read.value);
            let found = bundle.parts().iter().find_map(|(part, target)| {
                let called = match (part == name, last) {
                    (true, _) => alias.clone(),
                    (false, true) => format!("{part}_last"),
                    (false, false) => part.clone(),
                };
                (called == variable).then(|| target.clone())
            });
            if let Some(target) = found {
                self.used.insert(read.value.clone());
                return Some(match (last, target) {
                    (true, Target::Resource(index)) => {
                        self.context.resources[index].life = Life::History;
                        Target::Last(index)
                    }
                    (_, target) => target,
                });
            }
        }
        None
    }

    fn constants(&self, shader: usize, own: &[(String, f64)], with: Option<&Bundle>) -> Vec<(String, f64)> {
        let known = self.context.constants();
        let shader = &self.context.shaders[shader];
        let bundles: Vec<&Bundle> = with.into_iter().chain(self.bundles()).collect();
        shader
            .overrides()
            .iter()
            .filter_map(|item| {
                let name = item.name.as_str();
                let given = own.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
                let shared = || bundles.iter().find_map(|bundle| bundle.constant(name));
                let scene = || known.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
                let word = || {
                    let word = bundles.iter().find_map(|bundle| bundle.word(name))?;
                    word_value(shader, name, word)
                };
                // `HAS_X` of a thing x that the pass reads says whether it is there.
                let there =
                    || Some(f64::from(u8::from(self.has(&name.strip_prefix("HAS_")?.to_lowercase()))));
                let value = given.or_else(shared).or_else(scene).or_else(word).or_else(there)?;
                Some((item.name.clone(), value))
            })
            .collect()
    }

    /// Whether the entry reads something under this name, or a part of it, and it is made.
    fn has(&self, name: &str) -> bool {
        let unread = self.kind.unread(self.entry).iter().any(|unread| unread.port == name);
        !unread
            && self.entry.reads.iter().any(|read| {
                let bundle = self.context.bundles.get(&read.value);
                let is_it = self.entry.alias(&read.value) == name;
                bundle.is_some_and(|bundle| is_it || bundle.part(name).is_some())
            })
    }

    /// The uniform with the pass's parameters as a struct of its shader has them, read once however often it is bound.
    fn uniform(&mut self, shader: usize, variable: &str, structure: &'static str) -> Option<usize> {
        if let Some(known) = self.uniforms.get(structure) {
            return Some(*known);
        }
        let layout = self.context.shaders[shader].struct_layout(structure)?;
        let bytes = self.params.uniform(&self.context.shaders[shader], &layout, &mut self.context.faults);
        let name = format!("{}.{variable}", self.entry.name);
        let resource = self.context.resource(&name, ResourceKind::Uniform(bytes));
        let unread = self.kind.unread(self.entry);
        let decides = |name: &str| unread.iter().any(|unread| unread.decided_by == Some(name));
        self.slots.extend(layout.fields.iter().map(|field| ParamSlot {
            name: field.name.clone(),
            resource,
            shader: (shader, structure),
            fixed: decides(&field.name),
        }));
        self.uniforms.insert(structure, resource);
        Some(resource)
    }

    fn program(&mut self, module: &str, entries: &[&'static str], own: &run::Given) -> Option<Program> {
        let with = own.bundle.as_ref();
        let mounts = self.mounts(&own.mounts, with);
        let shader = self.context.shader(module, &mounts)?;
        self.traces |= self.context.shaders[shader].links(self.tracer.modules);
        let mut bindings: Vec<Binding> = Vec::new();
        for entry in entries {
            for binding in self.context.shaders[shader].bindings(entry) {
                if !bindings
                    .iter()
                    .any(|other| (other.group, other.binding) == (binding.group, binding.binding))
                {
                    bindings.push(binding);
                }
            }
        }
        bindings.sort_by_key(|binding| (binding.group, binding.binding));
        let binds = bindings.into_iter().map(|binding| {
            let given = own.targets.iter().find(|(name, _)| *name == binding.name);
            let target = match given {
                Some((_, target)) => target.clone(),
                None => self.target(&binding, shader, with)?,
            };
            self.fits(&binding, &target);
            let Binding { group, binding, name, kind, .. } = binding;
            Some(Bind { group, binding, name, kind, target })
        });
        let binds = binds.collect::<Vec<_>>().into_iter().collect::<Option<Vec<Bind>>>()?;
        let constants = self.constants(shader, &own.constants, with);
        Some(Program { shader, entry: entries[0], constants, binds })
    }

    /// Whether a variable can be bound to this image: a fault if its texels are of another kind.
    fn fits(&mut self, binding: &Binding, target: &Target) {
        let (Target::Resource(index) | Target::Last(index) | Target::Mip { resource: index, .. }) = target
        else {
            return;
        };
        let resource = &self.context.resources[*index];
        let ResourceKind::Image { texel, .. } = resource.kind else { return };
        if let Some(wanted) = texel.misfit(&binding.kind) {
            let message =
                format!("pass `{}` can't have `{}` as `{}`", self.entry.name, resource.name, binding.name);
            let label = format!("its texels are {}; the shader's variable wants {wanted}", texel.name());
            self.context.faults.push(self.context.pipeline.fault(&self.entry.run.span, message, label));
        }
    }
}

/// Variables that hold a pass's parameters, and the structs that say what these are: the pass's own and its tracer's.
const PARAMS: [(&str, &str); 2] = [("params", "Params"), ("trace_params", "TraceParams")];

/// Follows the name of what is read as it was before its last writing: `mean.last`.
pub(crate) const LAST: &str = ".last";

/// What a word stands for in an `override`: the value of the shader's constant `<NAME>_<WORD>`.
fn word_value(shader: &Shader, name: &str, word: &str) -> Option<f64> {
    let (_, value) = words(shader, name).into_iter().find(|(known, _)| known == word)?;
    Some(f64::from(value))
}

/// The uniform that says which repetition of a pass this is.
pub(crate) fn step_params(level: u32) -> Target {
    let mut bytes = vec![0; 16];
    bytes[..4].copy_from_slice(&level.to_le_bytes());
    Target::Uniform(bytes)
}

/// An image of the screen's size.
pub fn screen_image(texel: ImageTexel, layers: u32) -> ResourceKind {
    ResourceKind::Image { extent: ImageExtent::SCREEN, texel, layers, mips: 1 }
}

/// Workgroups for so many items in a row: x, then rows of at most `ROW_GROUPS` (see wgsl/common/dispatch.wgsl).
pub(crate) fn groups_for(items: u32, size: u32) -> [u32; 3] {
    const ROW_GROUPS: u32 = 32768;
    let groups = items.div_ceil(size);
    [groups.min(ROW_GROUPS), groups.div_ceil(ROW_GROUPS), 1]
}
