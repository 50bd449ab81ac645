//! What programs are bound to that is no resource of a plan: constants, and stand-ins for what was left out.

use std::collections::HashMap;

use voxlume_shader::{Access, BindingKind, SampleKind, TextureDim};

use crate::Error;
use crate::host::Host;
use crate::layout::{dimension, storage_format};

/// All that were needed so far, by content.
#[derive(Debug, Default)]
pub(crate) struct Fillers {
    constants: HashMap<Vec<u8>, wgpu::Buffer>,
    nothings: HashMap<BindingKind, Held>,
}

/// What a bind group holds; kept while it is made.
#[derive(Clone, Debug)]
pub(crate) enum Held {
    Buffer(wgpu::Buffer),
    View(wgpu::TextureView),
    Sampler(wgpu::Sampler),
}

impl Held {
    pub fn bound(&self) -> wgpu::BindingResource<'_> {
        match self {
            Held::Buffer(buffer) => buffer.as_entire_binding(),
            Held::View(view) => wgpu::BindingResource::TextureView(view),
            Held::Sampler(sampler) => wgpu::BindingResource::Sampler(sampler),
        }
    }
}

impl Fillers {
    /// A uniform buffer that never changes.
    pub fn constant(&mut self, host: &mut Host, label: &str, bytes: &[u8]) -> Result<wgpu::Buffer, Error> {
        if let Some(known) = self.constants.get(bytes) {
            return Ok(known.clone());
        }
        let buffer = host.buffer_with(label, bytes, wgpu::BufferUsages::UNIFORM)?;
        self.constants.insert(bytes.to_vec(), buffer.clone());
        Ok(buffer)
    }

    /// One element of zeroes in place of what was left out.
    pub fn nothing(&mut self, host: &mut Host, kind: &BindingKind) -> Result<Held, Error> {
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
