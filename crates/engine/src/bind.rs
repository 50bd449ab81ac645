//! What a program's variables are bound to.

use std::collections::HashMap;

use voxlume_graph::{Bind, Program, Resource, Target};
use voxlume_shader::{Access, BindingKind, SampleKind, TextureDim};

use crate::Error;
use crate::host::Host;
use crate::layout::{dimension, storage_format};
use crate::program::{Compiled, Pipeline};
use crate::resources::{Object, Resources};

/// Bind groups by their index; `None` for an index that nothing uses.
pub(crate) type BindGroups = Vec<Option<wgpu::BindGroup>>;

/// What programs are bound to that is no resource of a plan; kept by content.
#[derive(Debug, Default)]
pub(crate) struct Fillers {
    constants: HashMap<Vec<u8>, wgpu::Buffer>,
    nothings: HashMap<BindingKind, Held>,
}

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

/// What a bind group holds; kept while it is made.
#[derive(Clone, Debug)]
enum Held {
    Buffer(wgpu::Buffer),
    View(wgpu::TextureView),
    Sampler(wgpu::Sampler),
}

impl Held {
    fn bound(&self) -> wgpu::BindingResource<'_> {
        match self {
            Held::Buffer(buffer) => buffer.as_entire_binding(),
            Held::View(view) => wgpu::BindingResource::TextureView(view),
            Held::Sampler(sampler) => wgpu::BindingResource::Sampler(sampler),
        }
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

impl Fillers {
    /// A uniform buffer that never changes.
    fn constant(&mut self, host: &mut Host, label: &str, bytes: &[u8]) -> Result<wgpu::Buffer, Error> {
        if let Some(known) = self.constants.get(bytes) {
            return Ok(known.clone());
        }
        let buffer = host.buffer_with(label, bytes, wgpu::BufferUsages::UNIFORM)?;
        self.constants.insert(bytes.to_vec(), buffer.clone());
        Ok(buffer)
    }

    /// One element of zeroes in place of what was left out.
    fn nothing(&mut self, host: &mut Host, kind: &BindingKind) -> Result<Held, Error> {
        if let Some(known) = self.nothings.get(kind) {
            return Ok(known.clone());
        }
        let made = nothing(host, kind)?;
        let is_written = match kind {
            BindingKind::Storage { read_only, .. } => !read_only,
            BindingKind::StorageTexture { access, .. } => *access != Access::ReadOnly,
            _ => false,
        };
        // No two variables may write to one place.
        if !is_written {
            self.nothings.insert(kind.clone(), made.clone());
        }
        Ok(made)
    }
}

fn nothing(host: &mut Host, kind: &BindingKind) -> Result<Held, Error> {
    let sampled = wgpu::TextureUsages::TEXTURE_BINDING;
    let (dim, format, usage) = match kind {
        BindingKind::Texture { dim, sample, .. } => {
            let format = match sample {
                SampleKind::Float => wgpu::TextureFormat::Rgba16Float,
                SampleKind::Depth => wgpu::TextureFormat::Depth32Float,
                SampleKind::Uint => wgpu::TextureFormat::R32Uint,
                SampleKind::Sint => wgpu::TextureFormat::R32Sint,
            };
            (*dim, format, sampled)
        }
        BindingKind::StorageTexture { dim, format, .. } => {
            (*dim, storage_format(format), wgpu::TextureUsages::STORAGE_BINDING)
        }
        BindingKind::Uniform { size } => {
            let zeroes = vec![0; *size as usize];
            return host.buffer_with("nothing", &zeroes, wgpu::BufferUsages::UNIFORM).map(Held::Buffer);
        }
        BindingKind::Storage { .. } | BindingKind::Sampler { .. } => {
            return host.buffer_with("nothing", &[], wgpu::BufferUsages::STORAGE).map(Held::Buffer);
        }
    };
    let is_volume = dim == TextureDim::D3;
    let texture = host.texture(&wgpu::TextureDescriptor {
        label: Some("nothing"),
        size: wgpu::Extent3d { width: 1, height: 1, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: if is_volume { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 },
        format,
        usage,
        view_formats: &[],
    })?;
    let descriptor = wgpu::TextureViewDescriptor { dimension: Some(dimension(dim)), ..Default::default() };
    Ok(Held::View(texture.create_view(&descriptor)))
}
