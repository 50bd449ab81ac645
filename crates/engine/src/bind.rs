//! What a program's variables are bound to.

use std::collections::HashMap;

use voxlume_graph::{Bind, Program, Resource, Target};
use voxlume_shader::BindingKind;

use crate::Error;
use crate::filler::{Fillers, Held};
use crate::host::Host;
use crate::layout::dimension;
use crate::program::{Compiled, Pipeline};
use crate::resources::{Object, Resources};

/// Bind groups by their index; `None` for an index that nothing uses.
pub(crate) type BindGroups = Vec<Option<wgpu::BindGroup>>;

/// A program with its bind groups.
#[derive(Debug)]
pub(crate) struct Bound {
    compiled: Compiled,
    /// The resources among its own of which there are two.
    histories: Vec<usize>,
    /// By which of the two is the newest, for each of these.
    groups: HashMap<Vec<usize>, BindGroups>,
}

impl Bound {
    pub fn new(compiled: Compiled, program: &Program, resources: &[Resource]) -> Bound {
        let all = program.binds.iter().filter_map(|bind| resource_of(&bind.target));
        let mut histories: Vec<usize> =
            all.filter(|index| resources[*index].life == voxlume_graph::Life::History).collect();
        histories.sort_unstable();
        histories.dedup();
        Bound { compiled, histories, groups: HashMap::new() }
    }

    fn key(&self, resources: &Resources) -> Vec<usize> {
        self.histories.iter().map(|index| resources.place(*index)).collect()
    }

    /// The pipeline, and its bind groups where [`Bound::prepare`] has made them.
    pub fn ready(&self, resources: &Resources) -> (&Pipeline, Option<&BindGroups>) {
        (&self.compiled.pipeline, self.groups.get(&self.key(resources)))
    }

    /// Makes the bind groups for resources as they stand, unless they are there.
    pub fn prepare(
        &mut self,
        host: &mut Host,
        fillers: &mut Fillers,
        resources: &Resources,
        label: &str,
        program: &Program,
    ) -> Result<(), Error> {
        let key = self.key(resources);
        if !self.groups.contains_key(&key) {
            let groups = bind_groups(host, fillers, resources, label, program, &self.compiled)?;
            self.groups.insert(key, groups);
        }
        Ok(())
    }

    /// Drops bind groups that hold one of these resources, which were made anew.
    pub fn release(&mut self, program: &Program, remade: &[usize]) {
        let mut bound = program.binds.iter().filter_map(|bind| resource_of(&bind.target));
        if bound.any(|index| remade.contains(&index)) {
            self.groups.clear();
        }
    }
}

fn resource_of(target: &Target) -> Option<usize> {
    match target {
        Target::Resource(index) | Target::Last(index) | Target::Mip { resource: index, .. } => Some(*index),
        Target::Uniform(_) | Target::Nothing => None,
    }
}

fn bind_groups(
    host: &mut Host,
    fillers: &mut Fillers,
    resources: &Resources,
    label: &str,
    program: &Program,
    compiled: &Compiled,
) -> Result<BindGroups, Error> {
    let mut groups = Vec::new();
    for (group, layout) in compiled.layouts.iter().enumerate() {
        let Some(layout) = layout else {
            groups.push(None);
            continue;
        };
        let binds: Vec<&Bind> = program.binds.iter().filter(|bind| bind.group as usize == group).collect();
        let held = binds.iter().map(|bind| hold(host, fillers, resources, bind));
        let held = held.collect::<Result<Vec<Held>, Error>>()?;
        let bound = binds.iter().zip(&held);
        let entries =
            bound.map(|(bind, held)| wgpu::BindGroupEntry { binding: bind.binding, resource: held.bound() });
        let entries: Vec<_> = entries.collect();
        let descriptor = wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries };
        host.counters.bind_groups += 1;
        groups.push(Some(host.gpu.guarded(label, || host.gpu.device.create_bind_group(&descriptor))?));
    }
    Ok(groups)
}

fn hold(host: &mut Host, fillers: &mut Fillers, resources: &Resources, bind: &Bind) -> Result<Held, Error> {
    let dimension = match &bind.kind {
        BindingKind::Texture { dim, .. } | BindingKind::StorageTexture { dim, .. } => Some(dimension(*dim)),
        _ => None,
    };
    let object = match &bind.target {
        Target::Resource(index) | Target::Mip { resource: index, .. } => resources.newest(*index),
        Target::Last(index) => resources.last(*index),
        Target::Uniform(bytes) => return fillers.constant(host, &bind.name, bytes).map(Held::Buffer),
        Target::Nothing => return fillers.nothing(host, &bind.kind),
    };
    let (base_mip_level, mip_level_count) = match bind.target {
        Target::Mip { mip, .. } => (mip, Some(1)),
        _ => (0, None),
    };
    match object {
        Object::Buffer(buffer) => Ok(Held::Buffer(buffer.clone())),
        Object::Sampler(sampler) => Ok(Held::Sampler(sampler.clone())),
        Object::Texture(texture) => Ok(Held::View(texture.create_view(&wgpu::TextureViewDescriptor {
            dimension,
            base_mip_level,
            mip_level_count,
            ..Default::default()
        }))),
        Object::Pending => fillers.nothing(host, &bind.kind),
    }
}
