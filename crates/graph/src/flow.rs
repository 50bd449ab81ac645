//! What a pass depends on and what it leaves, read off its steps.

use std::collections::BTreeSet;

use voxlume_shader::{Access, BindingKind};

use crate::plan::{
    Bind, Groups, ParamSlot, Program, Resource, ResourceKind, Sources, Step, Target, Vertices,
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
    /// Of steps in this order, of a pass with these parameters. A resource is an input if a step reads it before any step of the pass has written it.
    pub fn of(steps: &[Step], resources: &[Resource], params: &[ParamSlot]) -> Flow {
        let mut flow = Flow::default();
        let mut written = BTreeSet::new();
        let mut inputs = BTreeSet::new();
        for step in steps {
            let (reads, writes) = touched(step);
            for index in reads {
                let resource = &resources[index];
                match resource.kind {
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
            written.extend(writes);
            flow.sources.time |= reads_last(step);
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

/// How the uniform with a pass's parameters is called, after the pass's own name.
pub(crate) const PARAMS_SUFFIX: &str = ".params";

fn reads_last(step: &Step) -> bool {
    program(step)
        .is_some_and(|program| program.binds.iter().any(|bind| matches!(bind.target, Target::Last(_))))
}

fn program(step: &Step) -> Option<&Program> {
    match step {
        Step::Compute { program, .. } | Step::Draw { program, .. } | Step::Raster { program, .. } => {
            Some(program)
        }
        Step::Clear(_) | Step::Copy { .. } | Step::Counted => None,
    }
}

/// The resources that a step reads and those that it writes.
fn touched(step: &Step) -> (Vec<usize>, Vec<usize>) {
    let (mut reads, mut writes) = (Vec::new(), Vec::new());
    for bind in program(step).into_iter().flat_map(|program| &program.binds) {
        let (Target::Resource(index) | Target::Mip { resource: index, .. }) = bind.target else { continue };
        let (read, write) = access(bind);
        reads.extend(read.then_some(index));
        writes.extend(write.then_some(index));
    }
    match step {
        Step::Clear(index) => writes.push(*index),
        Step::Copy { from, to } => {
            reads.push(*from);
            writes.push(*to);
        }
        Step::Compute { groups: Groups::Indirect { resource, .. }, .. } => reads.push(*resource),
        Step::Compute { .. } | Step::Counted => {}
        Step::Draw { colors, depth, .. } => writes.extend(colors.iter().flatten().chain([&depth.0])),
        Step::Raster { vertices: Vertices::Indirect { resource, .. }, .. } => reads.push(*resource),
        Step::Raster { .. } => {}
    }
    (reads, writes)
}

/// Whether a variable reads, and whether it writes. A storage buffer that is written is read as well: its atomics and sums
/// go on from what is there.
fn access(bind: &Bind) -> (bool, bool) {
    match &bind.kind {
        BindingKind::Storage { read_only, .. } => (true, !read_only),
        BindingKind::StorageTexture { access, .. } => {
            (*access != Access::WriteOnly, *access != Access::ReadOnly)
        }
        _ => (true, false),
    }
}
