//! How a program's variables are laid out.

use voxlume_graph::Program;
use voxlume_shader::{Access, BindingKind, SampleKind, TextureDim};

/// Layouts of bind groups by their index; `None` for an index that nothing uses.
pub(crate) type Layouts = Vec<Option<wgpu::BindGroupLayout>>;

fn group_count(program: &Program) -> u32 {
    program.binds.iter().map(|bind| bind.group + 1).max().unwrap_or(0)
}

pub(crate) fn layouts(device: &wgpu::Device, program: &Program, visibility: wgpu::ShaderStages) -> Layouts {
    (0..group_count(program))
        .map(|group| {
            let entries: Vec<_> = program
                .binds
                .iter()
                .filter(|bind| bind.group == group)
                .map(|bind| wgpu::BindGroupLayoutEntry {
                    binding: bind.binding,
                    visibility: match bind.kind {
                        // No vertex shader may write.
                        BindingKind::Storage { read_only: false, .. } => {
                            visibility - wgpu::ShaderStages::VERTEX
                        }
                        _ => visibility,
                    },
                    ty: binding_type(&bind.kind),
                    count: None,
                })
                .collect();
            let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries };
            (!entries.is_empty()).then(|| device.create_bind_group_layout(&descriptor))
        })
        .collect()
}

pub(crate) fn dimension(dim: TextureDim) -> wgpu::TextureViewDimension {
    match dim {
        TextureDim::D1 => wgpu::TextureViewDimension::D1,
        TextureDim::D2 => wgpu::TextureViewDimension::D2,
        TextureDim::D2Array => wgpu::TextureViewDimension::D2Array,
        TextureDim::D3 => wgpu::TextureViewDimension::D3,
        TextureDim::Cube => wgpu::TextureViewDimension::Cube,
        TextureDim::CubeArray => wgpu::TextureViewDimension::CubeArray,
    }
}

fn binding_type(kind: &BindingKind) -> wgpu::BindingType {
    match kind {
        BindingKind::Uniform { .. } => wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        BindingKind::Storage { read_only, .. } => wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only: *read_only },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        BindingKind::Texture { dim, sample, multisampled, filterable } => wgpu::BindingType::Texture {
            sample_type: match sample {
                SampleKind::Float => wgpu::TextureSampleType::Float { filterable: *filterable },
                SampleKind::Depth => wgpu::TextureSampleType::Depth,
                SampleKind::Uint => wgpu::TextureSampleType::Uint,
                SampleKind::Sint => wgpu::TextureSampleType::Sint,
            },
            view_dimension: dimension(*dim),
            multisampled: *multisampled,
        },
        BindingKind::StorageTexture { dim, access, format } => wgpu::BindingType::StorageTexture {
            access: match access {
                Access::ReadOnly => wgpu::StorageTextureAccess::ReadOnly,
                Access::WriteOnly => wgpu::StorageTextureAccess::WriteOnly,
                Access::ReadWrite => wgpu::StorageTextureAccess::ReadWrite,
            },
            format: storage_format(format),
            view_dimension: dimension(*dim),
        },
        BindingKind::Sampler { comparison: true } => {
            wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison)
        }
        BindingKind::Sampler { comparison: false } => {
            wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)
        }
    }
}

/// The format of a storage texture by its word in WGSL, of those that volumes and images have.
pub(crate) fn storage_format(word: &str) -> wgpu::TextureFormat {
    match word {
        "rgba8unorm" => wgpu::TextureFormat::Rgba8Unorm,
        "rgba8snorm" => wgpu::TextureFormat::Rgba8Snorm,
        "rgba32float" => wgpu::TextureFormat::Rgba32Float,
        "rg32float" => wgpu::TextureFormat::Rg32Float,
        "r32float" => wgpu::TextureFormat::R32Float,
        "r32uint" => wgpu::TextureFormat::R32Uint,
        _ => wgpu::TextureFormat::Rgba16Float,
    }
}
