//! What a pass depends on and what it leaves, read off its steps.

use std::collections::BTreeSet;

use voxlume_shader::{Access, BindingKind, Shader};

use crate::plan::{
    Bind, Groups, Life, ParamSlot, Program, Resource, ResourceKind, Sources, Step, Target, Vertices,
};

/// What changes the part of the scene or the frame that the engine supplies under a name.
#[derive(Clone, Copy, PartialEq)]
enum Source {
    Nothing,
    Geometry,
    Lights,
    Camera,
    Time,
}

/// What the engine supplies: WGSL's name of each variable, and what changes it.
const SCENE: &[(&str, Source)] = &[
    ("camera", Source::Camera),
    ("clock", Source::Time),
    ("environment", Source::Lights),
    ("lights", Source::Lights),
    ("shadow_matrices", Source::Lights),
    ("vertices", Source::Geometry),
    ("indices", Source::Geometry),
    ("materials", Source::Nothing),
    ("color_textures", Source::Nothing),
    ("data_textures", Source::Nothing),
    ("material_sampler", Source::Nothing),
    ("shadow_sampler", Source::Nothing),
    ("volume_sampler", Source::Nothing),
];

/// Whether the engine supplies a variable of this name.
pub(crate) fn is_scene(name: &str) -> bool {
    SCENE.iter().any(|(known, _)| *known == name)
}

/// What the steps of a pass use, and what they leave.
#[derive(Default)]
pub(crate) struct Flow {
    pub sources: Sources,
    pub inputs: Vec<usize>,
    pub outputs: Vec<usize>,
}

impl Flow {
    /// Of steps in this order, of a pass with these parameters. A resource is an input if a step reads it before any step of
    /// the pass has written it.
    pub fn of(steps: &[Step], shaders: &[Shader], resources: &[Resource], params: &[ParamSlot]) -> Flow {
        let mut flow = Flow::default();
        let mut written = BTreeSet::new();
        let mut inputs = BTreeSet::new();
        for step in steps {
            let touches = step.touches();
            let read = touches.iter().filter(|touch| touch.reads && !is_only_written(step, touch, shaders));
            for index in read.map(|touch| touch.resource) {
                let resource = &resources[index];
                match resource.kind {
                    _ if resource.life == Life::Kept => {}
                    ResourceKind::Scene => flow.depends(&resource.name),
                    ResourceKind::Uniform(_) => {
                        flow.sources.parameters |= params.iter().any(|slot| slot.resource == index);
                    }
                    _ if !written.contains(&index) => {
                        inputs.insert(index);
                    }
                    _ => {}
                }
            }
            written.extend(touches.iter().filter(|touch| touch.writes).map(|touch| touch.resource));
            flow.sources.time |= step.reads_last();
        }
        flow.inputs = inputs.into_iter().collect();
        flow.outputs = written.into_iter().collect();
        flow
    }

    fn depends(&mut self, name: &str) {
        match SCENE.iter().find(|(known, _)| *known == name).map_or(Source::Nothing, |(_, source)| *source) {
            Source::Nothing => {}
            Source::Geometry => self.sources.geometry = true,
            Source::Lights => self.sources.lights = true,
            Source::Camera => self.sources.camera = true,
            Source::Time => self.sources.time = true,
        }
    }
}

/// Whether the variable of a storage buffer that may be read and written is only written by the step's program. A buffer
/// that passes use for their own ends, one after the other, is no input then.
fn is_only_written(step: &Step, touch: &Touch, shaders: &[Shader]) -> bool {
    let Some(program) = step.program().filter(|_| touch.writes) else { return false };
    let shader = &shaders[program.shader];
    let reads = |variable: &str| match step {
        Step::Compute { .. } => shader.reads(program.entry, variable),
        _ => shader.entry_points().iter().any(|entry| shader.reads(&entry.name, variable)),
    };
    let mut bound = program.binds.iter().filter(|bind| bind.target == Target::Resource(touch.resource));
    bound.all(|bind| !reads(&bind.name))
}

/// A resource in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Touch {
    /// In [`Plan::resources`](crate::Plan::resources).
    pub resource: usize,
    /// Whether the step uses what is there.
    pub reads: bool,
    /// Whether it changes it.
    pub writes: bool,
}

impl Step {
    /// The program that it runs.
    pub fn program(&self) -> Option<&Program> {
        match self {
            Step::Compute { program, .. } | Step::Draw { program, .. } | Step::Raster { program, .. } => {
                Some(program)
            }
            Step::Clear(_) | Step::Copy { .. } | Step::Counted => None,
        }
    }

    /// Every resource that it touches, but for last values.
    pub fn touches(&self) -> Vec<Touch> {
        let read = |resource: usize| Touch { resource, reads: true, writes: false };
        let write = |resource: usize| Touch { resource, reads: false, writes: true };
        let mut touches: Vec<Touch> =
            self.program().into_iter().flat_map(|program| &program.binds).filter_map(bound).collect();
        match self {
            Step::Clear(index) => touches.push(write(*index)),
            Step::Copy { from, to } => touches.extend([read(*from), write(*to)]),
            Step::Compute { groups: Groups::Indirect { resource, .. }, .. }
            | Step::Raster { vertices: Vertices::Indirect { resource, .. }, .. } => {
                touches.push(read(*resource))
            }
            Step::Draw { colors, depth, .. } => {
                touches.extend(colors.iter().flatten().chain([&depth.0]).map(|index| write(*index)));
            }
            Step::Compute { .. } | Step::Raster { .. } | Step::Counted => {}
        }
        if let Step::Raster { target, .. } = self {
            touches.push(write(*target));
        }
        touches
    }

    fn reads_last(&self) -> bool {
        let last = |bind: &Bind| matches!(bind.target, Target::Last(_));
        self.program().is_some_and(|program| program.binds.iter().any(last))
    }
}

/// How a variable touches its resource. A storage buffer that is written is read as well: its atomics and sums go on from
/// what is there.
fn bound(bind: &Bind) -> Option<Touch> {
    let (Target::Resource(resource) | Target::Mip { resource, .. }) = bind.target else { return None };
    let (reads, writes) = match &bind.kind {
        BindingKind::Storage { read_only, .. } => (true, !read_only),
        BindingKind::StorageTexture { access, .. } => {
            (*access != Access::WriteOnly, *access != Access::ReadOnly)
        }
        _ => (true, false),
    };
    Some(Touch { resource, reads, writes })
}
