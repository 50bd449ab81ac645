//! One entry of a pipeline on its way to steps.

mod ask;
mod bind;
pub(crate) mod context;
mod make;
mod run;

use std::collections::{BTreeMap, BTreeSet};

pub(crate) use context::{Context, Mounts};
pub use run::{Over, Run};

use crate::params::Params;
use crate::pass::PassKind;
use crate::pipeline::PassEntry;
use crate::plan::{ImageExtent, ImageTexel, ParamSlot, ResourceKind, Step, Target};
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

    /// Reports what the entry names and the pass never used, and parameters that nobody read.
    pub(crate) fn finish(self) -> Expanded {
        for name in &self.entry.reads {
            let unread = self.kind.unread(self.entry, self.tracer).iter().any(|unread| {
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

/// Follows the name of what is read as it was before its last writing: `mean.last`.
pub(crate) const LAST: &str = ".last";

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
