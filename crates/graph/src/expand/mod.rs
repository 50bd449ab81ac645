//! Passes as steps.

pub(crate) mod context;
pub(crate) mod gbuffer;
pub(crate) mod light;
pub(crate) mod screen;
pub(crate) mod shadow_maps;
pub(crate) mod voxel_view;
pub(crate) mod voxelize;

use std::collections::{BTreeMap, BTreeSet};

use voxlume_shader::{Binding, Shader};

pub(crate) use context::{Context, Storage};

use crate::kind::{Kind, SURFACE_IMAGES};
use crate::params::{Params, words};
use crate::pipeline::PassEntry;
use crate::plan::{Bind, Program, ResourceKind, Step, Target};
use crate::tracer::Tracer;

/// Variables that the engine supplies.
const SCENE: [&str; 11] = [
    "frame",
    "vertices",
    "indices",
    "materials",
    "lights",
    "color_textures",
    "data_textures",
    "material_sampler",
    "shadow_sampler",
    "shadow_matrices",
    "volume_sampler",
];

/// Variables that make up `voxels`.
const VOXELS: [&str; 12] = [
    "occupancy",
    "ranks",
    "cells",
    "levels",
    "attributes",
    "item_ranks",
    "item_groups",
    "scan_runs",
    "static_occupancy",
    "static_ranks",
    "static_attributes",
    "occupancy_before",
];

/// `@group` of the storage format's variables.
const VOLUME_GROUP: u32 = 2;

/// One pass on its way to steps.
pub(crate) struct Expansion<'c, 'a> {
    pub context: &'c mut Context<'a>,
    pub entry: &'a PassEntry,
    pub kind: &'static Kind,
    pub params: Params<'a>,
    pub tracer: &'a Tracer,
    pub steps: Vec<Step>,
    /// Steps before these, which have to be done only once.
    pub once: Vec<Step>,
    used: BTreeSet<String>,
    traces: bool,
    uniforms: BTreeMap<&'static str, Target>,
}

/// What a program is bound to beside the variables that everybody knows.
#[derive(Default)]
pub(crate) struct Binds<'b> {
    pub targets: &'b [(&'b str, Target)],
    pub constants: &'b [(&'b str, f64)],
    /// A name that the module imports from and the module that it stands for.
    pub mount: Option<(&'b str, &'b str)>,
}

impl<'c, 'a> Expansion<'c, 'a> {
    pub fn new(context: &'c mut Context<'a>, entry: &'a PassEntry, kind: &'static Kind) -> Expansion<'c, 'a> {
        let params = Params::of(context.pipeline, entry);
        let tracer = context.tracers.of(context.pipeline, entry);
        Expansion {
            context,
            entry,
            kind,
            params,
            tracer,
            steps: Vec::new(),
            once: Vec::new(),
            used: BTreeSet::new(),
            traces: false,
            uniforms: BTreeMap::new(),
        }
    }

    /// Links a shader and binds what one entry point of it uses.
    pub fn program(&mut self, module: &str, entry: &'static str, binds: &Binds<'_>) -> Option<Program> {
        self.program_of(module, &[entry], binds)
    }

    /// Links a shader and binds what several of its entry points use together.
    pub fn program_of(
        &mut self,
        module: &str,
        entries: &[&'static str],
        binds: &Binds<'_>,
    ) -> Option<Program> {
        let shader = self.context.shader(module, binds.mount, self.tracer)?;
        if self.context.shaders[shader].links(self.tracer.modules) {
            self.traces = true;
            // Opacity alone may take less than all.
            self.used.extend(self.tracer.reads.iter().map(|name| (*name).to_owned()));
        }
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
        let binds_of = bindings
            .into_iter()
            .map(|binding| {
                let given = binds.targets.iter().find(|(name, _)| *name == binding.name);
                let target = match given {
                    Some((_, target)) => target.clone(),
                    None => self.target(&binding, shader)?,
                };
                Some(Bind {
                    group: binding.group,
                    binding: binding.binding,
                    name: binding.name,
                    kind: binding.kind,
                    target,
                })
            })
            .collect::<Vec<Option<Bind>>>();
        let constants = self.constants(shader, binds.constants);
        Some(Program {
            shader,
            entry: entries[0],
            constants,
            binds: binds_of.into_iter().collect::<Option<Vec<Bind>>>()?,
        })
    }

    fn constants(&self, shader: usize, own: &[(&str, f64)]) -> Vec<(String, f64)> {
        let declared = self.context.shaders[shader].overrides();
        let known = self.context.constants();
        declared
            .iter()
            .filter_map(|item| {
                let value = own.iter().chain(&known).find(|(name, _)| *name == item.name).map(|(_, v)| *v);
                // `HAS_X` of an image x says whether it is there to be read.
                let image = || {
                    let image = item.name.strip_prefix("HAS_")?.to_lowercase();
                    Some(f64::from(u8::from(self.reads(&image) && self.context.available.contains(&image))))
                };
                let word = || match item.name.as_str() {
                    "CONFLICT" => Some(self.context.conflict),
                    name => self.context.storage.word_of(name),
                };
                let word = || word_value(&self.context.shaders[shader], &item.name, word()?);
                Some((item.name.clone(), value.or_else(word).or_else(image)?))
            })
            .collect()
    }

    /// Whether the entry says that it reads `name`.
    pub fn reads(&self, name: &str) -> bool {
        self.entry.reads.iter().any(|read| read.value == name)
    }

    fn target(&mut self, binding: &Binding, shader: usize) -> Option<Target> {
        let name = binding.name.as_str();
        if SCENE.contains(&name) {
            return Some(Target::Resource(self.context.resource(name, ResourceKind::Scene)));
        }
        match name {
            "params" => return self.uniform(shader, "Params"),
            "trace_params" => return self.uniform(shader, "TraceParams"),
            _ => {}
        }
        let volume = self.context.storage.volumes().iter().any(|volume| volume.name == name);
        if binding.group == VOLUME_GROUP && !volume {
            // What another choice of the format's options would have.
            return Some(Target::Nothing);
        }
        let group = if VOXELS.contains(&name) {
            "voxels"
        } else if volume {
            "volume"
        } else if SURFACE_IMAGES.contains(&name) {
            "surface"
        } else {
            name
        };
        let all = || self.entry.reads.iter().chain(&self.entry.writes).chain(&self.entry.updates);
        if all().any(|entry| entry.value == group) {
            self.used.insert(group.to_owned());
            return Some(self.context.known(name).map_or(Target::Nothing, Target::Resource));
        }
        let optional = self.kind.reads.iter().any(|port| port.name == group && port.optional);
        let guarded = self.context.shaders[shader]
            .overrides()
            .iter()
            .any(|o| o.name == format!("HAS_{}", name.to_uppercase()));
        if optional || guarded {
            return Some(Target::Nothing);
        }
        let message = format!("pass `{}` uses `{group}` without reading it", self.entry.name);
        let label = format!("its shader's variable `{name}` needs `{group}` in `reads`");
        // A volume is several textures.
        if !self.context.faults.iter().any(|fault| fault.message == message) {
            self.context.faults.push(self.context.pipeline.fault(&self.entry.run.span, message, label));
        }
        None
    }

    /// Says that the pass uses a resource of the graph otherwise than through a variable.
    pub fn uses(&mut self, name: &str) {
        self.used.insert(name.to_owned());
    }

    /// Reports what the entry names and the pass never used, and parameters that nobody read.
    ///
    /// Gives the steps that have to be done only once, and the others.
    pub fn finish(self) -> (Vec<Step>, Vec<Step>) {
        for name in &self.entry.reads {
            if !self.used.contains(&name.value) && self.context.faults.is_empty() {
                let message = format!("pass `{}` never uses `{}`", self.entry.name, name.value);
                self.context.faults.push(self.context.pipeline.fault(&name.span, message, "read in vain"));
            }
        }
        // Without its shader a pass's parameters are unknown.
        if !self.steps.is_empty() || self.kind.name == "bounce" {
            self.params.finish(self.traces, self.context);
            let in_vain = self.entry.tracer.as_ref().filter(|_| !self.traces);
            self.context.faults.extend(in_vain.map(|word| {
                let message = format!("pass `{}` traces nothing", self.entry.name);
                self.context.pipeline.fault(&word.span, message, "a tracer named in vain")
            }));
        }
        (self.once, self.steps)
    }

    /// The pass's parameters as a struct of its shader has them, read once however often it is bound.
    fn uniform(&mut self, shader: usize, name: &'static str) -> Option<Target> {
        if !self.uniforms.contains_key(name) {
            let shader = &self.context.shaders[shader];
            let layout = shader.struct_layout(name)?;
            let bytes = self.params.uniform(shader, &layout, &mut self.context.faults);
            self.uniforms.insert(name, Target::Uniform(bytes));
        }
        self.uniforms.get(name).cloned()
    }
}

/// What a word stands for in an `override`: the value of the shader's constant `<NAME>_<WORD>`.
fn word_value(shader: &Shader, name: &str, word: &str) -> Option<f64> {
    let (_, value) = words(shader, name).into_iter().find(|(known, _)| known == word)?;
    Some(f64::from(value))
}

/// The uniform that says which repetition of a pass this is.
pub(crate) fn step_params(level: u32) -> (&'static str, Target) {
    let mut bytes = vec![0; 16];
    bytes[..4].copy_from_slice(&level.to_le_bytes());
    ("step_params", Target::Uniform(bytes))
}

/// Workgroups for so many items in a row: x, then rows of at most `ROW_GROUPS` (see wgsl/common/dispatch.wgsl).
pub(crate) fn groups_for(items: u32, size: u32) -> [u32; 3] {
    const ROW_GROUPS: u32 = 32768;
    let groups = items.div_ceil(size);
    [groups.min(ROW_GROUPS), groups.div_ceil(ROW_GROUPS), 1]
}
