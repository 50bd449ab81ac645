//! What a program's variables and constants are bound to.

use voxlume_shader::{Binding, Shader};

use crate::bundle::Bundle;
use crate::expansion::{Expansion, LAST, Mounts, run};
use crate::flow::is_scene;
use crate::params::words;
use crate::plan::{Bind, Life, ParamSlot, Program, ResourceKind, Target};

/// Variables that hold a pass's parameters, and the structs that say what these are: the pass's own and its tracer's.
const PARAMS: [(&str, &str); 2] = [("params", "Params"), ("trace_params", "TraceParams")];

impl Expansion<'_, '_> {
    /// The modules that imports below `package::<name>` mean: what a step says, then what the entry's bundles say, then the
    /// pipeline's.
    pub(super) fn mounts(&self, own: &[(&'static str, String)], with: Option<&Bundle>) -> Mounts {
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
        let unread = self.kind.unread(self.entry, self.tracer).iter().any(|unread| unread.port == name);
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
        let unread = self.kind.unread(self.entry, self.tracer);
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

    pub(super) fn program(
        &mut self,
        module: &str,
        entries: &[&'static str],
        own: &run::Given,
    ) -> Option<Program> {
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

/// What a word stands for in an `override`: the value of the shader's constant `<NAME>_<WORD>`.
fn word_value(shader: &Shader, name: &str, word: &str) -> Option<f64> {
    let (_, value) = words(shader, name).into_iter().find(|(known, _)| known == word)?;
    Some(f64::from(value))
}
