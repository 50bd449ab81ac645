//! What a program's variables are bound to.

use voxlume_graph::{Bind, Plan, Program, Target};
use voxlume_shader::{Access, BindingKind, SampleKind, TextureDim};

use crate::Gpu;
use crate::resources::{Object, buffer_with};

/// Bind groups by their index; `None` for an index that nothing uses.
pub(crate) type BindGroups = Vec<Option<wgpu::BindGroup>>;

fn group_count(program: &Program) -> u32 {
    program.binds.iter().map(|bind| bind.group + 1).max().unwrap_or(0)
}

pub(crate) fn layouts(
    gpu: &Gpu,
    program: &Program,
    visibility: wgpu::ShaderStages,
) -> Vec<Option<wgpu::BindGroupLayout>> {
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
            (!entries.is_empty()).then(|| gpu.device.create_bind_group_layout(&descriptor))
        })
        .collect()
}

fn dimension(dim: TextureDim) -> wgpu::TextureViewDimension {
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
fn storage_format(word: &str) -> wgpu::TextureFormat {
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

/// What a bind group holds; kept while it is made.
enum Held {
    Buffer(wgpu::Buffer),
    View(wgpu::TextureView),
    Sampler(wgpu::Sampler),
}

pub(crate) fn bind_groups(
    gpu: &Gpu,
    plan: &Plan,
    objects: &[Object],
    program: &Program,
    layouts: &[Option<wgpu::BindGroupLayout>],
) -> BindGroups {
    layouts
        .iter()
        .enumerate()
        .map(|(group, layout)| {
            let binds: Vec<&Bind> =
                program.binds.iter().filter(|bind| bind.group as usize == group).collect();
            let held: Vec<Held> = binds.iter().map(|bind| hold(gpu, plan, objects, bind)).collect();
            let entries: Vec<_> = binds
                .iter()
                .zip(&held)
                .map(|(bind, held)| wgpu::BindGroupEntry {
                    binding: bind.binding,
                    resource: match held {
                        Held::Buffer(buffer) => buffer.as_entire_binding(),
                        Held::View(view) => wgpu::BindingResource::TextureView(view),
                        Held::Sampler(sampler) => wgpu::BindingResource::Sampler(sampler),
                    },
                })
                .collect();
            let layout = layout.as_ref()?;
            Some(gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout,
                entries: &entries,
            }))
        })
        .collect()
}

fn hold(gpu: &Gpu, plan: &Plan, objects: &[Object], bind: &Bind) -> Held {
    match &bind.target {
        Target::Uniform(bytes) => {
            Held::Buffer(buffer_with(gpu, &bind.name, bytes, wgpu::BufferUsages::UNIFORM))
        }
        Target::Resource(index) | Target::Last(index) => match &objects[*index] {
            Object::Buffer(buffer) => Held::Buffer(buffer.clone()),
            Object::Sampler(sampler) => Held::Sampler(sampler.clone()),
            Object::Texture(texture) => Held::View(texture.create_view(&wgpu::TextureViewDescriptor {
                dimension: texture_dimension(&bind.kind),
                ..Default::default()
            })),
            Object::Pending => nothing(gpu, &bind.kind),
        },
        Target::Mip { resource, mip } => match &objects[*resource] {
            Object::Texture(texture) => Held::View(texture.create_view(&wgpu::TextureViewDescriptor {
                label: Some(&plan.resources[*resource].name),
                dimension: texture_dimension(&bind.kind),
                base_mip_level: *mip,
                mip_level_count: Some(1),
                ..Default::default()
            })),
            _ => nothing(gpu, &bind.kind),
        },
        Target::Nothing => nothing(gpu, &bind.kind),
    }
}

fn texture_dimension(kind: &BindingKind) -> Option<wgpu::TextureViewDimension> {
    match kind {
        BindingKind::Texture { dim, .. } | BindingKind::StorageTexture { dim, .. } => Some(dimension(*dim)),
        _ => None,
    }
}

/// One element of zeroes in place of what was left out.
fn nothing(gpu: &Gpu, kind: &BindingKind) -> Held {
    let (dim, format, usage) = match kind {
        BindingKind::Texture { dim, sample: SampleKind::Depth, .. } => {
            (*dim, wgpu::TextureFormat::Depth32Float, wgpu::TextureUsages::TEXTURE_BINDING)
        }
        BindingKind::Texture { dim, .. } => {
            (*dim, wgpu::TextureFormat::Rgba16Float, wgpu::TextureUsages::TEXTURE_BINDING)
        }
        BindingKind::StorageTexture { dim, format, .. } => {
            (*dim, storage_format(format), wgpu::TextureUsages::STORAGE_BINDING)
        }
        BindingKind::Uniform { size } => {
            let zeroes = vec![0; *size as usize];
            return Held::Buffer(buffer_with(gpu, "nothing", &zeroes, wgpu::BufferUsages::UNIFORM));
        }
        BindingKind::Storage { .. } | BindingKind::Sampler { .. } => {
            return Held::Buffer(buffer_with(gpu, "nothing", &[], wgpu::BufferUsages::STORAGE));
        }
    };
    let volume = dim == TextureDim::D3;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("nothing"),
        size: wgpu::Extent3d { width: 1, height: 1, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: if volume { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 },
        format,
        usage,
        view_formats: &[],
    });
    Held::View(
        texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(dimension(dim)),
            ..Default::default()
        }),
    )
}
