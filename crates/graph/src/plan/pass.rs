//! Passes of a plan: what each does, what it depends on, when it runs.

use super::Step;

/// One pass of the pipeline: it runs whole or not at all.
#[derive(Clone, Debug)]
pub struct Pass {
    /// The name in the pipeline.
    pub name: String,
    /// Names of the graph's resources that it reads, for `explain`.
    pub reads: Vec<String>,
    /// Names of those that it writes or updates.
    pub writes: Vec<String>,
    /// What to do, in order.
    pub steps: Vec<Step>,
    /// What it depends on beside `inputs`.
    pub sources: Sources,
    /// Resources, in [`Plan::resources`](super::Plan::resources), of which it uses what earlier passes, or it in an earlier frame, left there.
    pub inputs: Vec<usize>,
    /// Names in the graph of what is in `inputs`, for `explain`.
    pub waits_for: Vec<String>,
    /// Resources that it writes and that some pass, or the reader of the output, may find there.
    pub outputs: Vec<usize>,
    /// When it runs.
    pub update: Update,
    /// Its parameters that can be changed without planning again.
    pub params: Vec<ParamSlot>,
}

/// What a pass depends on beside the resources that other passes make.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sources {
    /// Where triangles are.
    pub geometry: bool,
    /// Lights and sky.
    pub lights: bool,
    /// The camera, and the screen's size.
    pub camera: bool,
    /// The pass's own parameters.
    pub parameters: bool,
    /// The frame's number and time: it runs in every frame.
    pub time: bool,
}

/// When a pass runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    /// In each frame in which something that it depends on has changed.
    Changed,
    /// Likewise, but at most once in so many frames (DVS, "Optimizations").
    Every(u32),
    /// In the first frame, and then in those for which it is asked by name.
    OnDemand,
}

/// A parameter's place in its pass's uniform buffer.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamSlot {
    /// The name in WGSL.
    pub name: String,
    /// The buffer, in [`Plan::resources`](super::Plan::resources).
    pub resource: usize,
    /// The shader that says what it takes, in [`Plan::shaders`](super::Plan::shaders), and its struct: `Params` or `TraceParams`.
    pub shader: (usize, &'static str),
    /// Whether the plan left something out for its value: another value needs another plan.
    pub fixed: bool,
}
