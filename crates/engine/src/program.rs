//! Programs as pipelines and bind groups.

use std::collections::HashMap;

use voxlume_graph::{Bind, Plan, Program, ResourceKind, Target};
use voxlume_shader::{Access, BindingKind, SampleKind, TextureDim};

use crate::resources::{Object, RASTER_FORMAT, buffer_with, image_format};
use crate::{Error, Gpu};

/// Pipelines and shader modules, each made once.
pub(crate) struct Programs {
    modules: Vec<wgpu::ShaderModule>,
    compute: HashMap<String, wgpu::ComputePipeline>,
    render: HashMap<String, wgpu::RenderPipeline>,
}

/// A program ready to run.
pub(crate) enum Ready {
    Compute(wgpu::ComputePipeline, BindGroups),
    Draw(wgpu::RenderPipeline, BindGroups),
}

/// Bind groups by their index; `None` for an index that nothing uses.
pub(crate) type BindGroups = Vec<Option<wgpu::BindGroup>>;

impl Programs {
    pub fn new(gpu: &Gpu, plan: &Plan) -> Result<Programs, Error> {
        let make = |shader: &voxlume_shader::Shader| {
            gpu.guarded("a shader", || {
                gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: None,
                    source: wgpu::ShaderSource::Wgsl(shader.wgsl.as_str().into()),
                })
            })
        };
        let modules = plan.shaders.iter().map(make).collect::<Result<_, _>>()?;
        Ok(Programs { modules, compute: HashMap::new(), render: HashMap::new() })
    }

    pub fn compute(
        &mut self,
        gpu: &Gpu,
        plan: &Plan,
        objects: &[Object],
        label: &str,
        program: &Program,
    ) -> Result<Ready, Error> {
        let key = format!("{} {} {:?}", program.shader, program.entry, program.constants);
        let visibility = wgpu::ShaderStages::COMPUTE;
        let layouts = layouts(gpu, program, visibility);
        if !self.compute.contains_key(&key) {
            let constants = constants(program);
            let module = &self.modules[program.shader];
            let pipeline = gpu.guarded(label, || {
                gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(label),
                    layout: Some(&pipeline_layout(gpu, &layouts)),
                    module,
                    entry_point: Some(program.entry),
                    compilation_options: options(&constants),
                    cache: None,
                })
            })?;
            self.compute.insert(key.clone(), pipeline);
        }
        let groups = gpu.guarded(label, || bind_groups(gpu, plan, objects, program, &layouts))?;
        Ok(Ready::Compute(self.compute[&key].clone(), groups))
    }

    #[expect(clippy::too_many_arguments, reason = "a draw is a program and its targets")]
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        plan: &Plan,
        objects: &[Object],
        label: &str,
        program: &Program,
        colors: &[Option<usize>],
        reversed: bool,
    ) -> Result<Ready, Error> {
        let target = |index: usize| {
            let ResourceKind::Image { texel, .. } = plan.resources[index].kind else { return None };
            Some(wgpu::ColorTargetState::from(image_format(texel)))
        };
        let targets: Vec<_> = colors.iter().map(|color| color.and_then(target)).collect();
        self.render(gpu, plan, objects, label, program, &targets, Some(depth_state(reversed)))
    }

    /// A program whose fragments write to buffers only.
    pub fn raster(
        &mut self,
        gpu: &Gpu,
        plan: &Plan,
        objects: &[Object],
        label: &str,
        program: &Program,
    ) -> Result<Ready, Error> {
        let target = wgpu::ColorTargetState {
            format: RASTER_FORMAT,
            blend: None,
            write_mask: wgpu::ColorWrites::empty(),
        };
        self.render(gpu, plan, objects, label, program, &[Some(target)], None)
    }

    #[expect(clippy::too_many_arguments, reason = "a draw is a program and its targets")]
    fn render(
        &mut self,
        gpu: &Gpu,
        plan: &Plan,
        objects: &[Object],
        label: &str,
        program: &Program,
        targets: &[Option<wgpu::ColorTargetState>],
        depth_stencil: Option<wgpu::DepthStencilState>,
    ) -> Result<Ready, Error> {
        let key = format!("{} {:?} {targets:?}", program.shader, program.constants);
        let layouts = layouts(gpu, program, wgpu::ShaderStages::VERTEX_FRAGMENT);
        if !self.render.contains_key(&key) {
            let constants = constants(program);
            let module = &self.modules[program.shader];
            let pipeline = gpu.guarded(label, || {
                gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                    label: Some(label),
                    layout: Some(&pipeline_layout(gpu, &layouts)),
                    vertex: wgpu::VertexState {
                        module,
                        entry_point: Some("vertex_main"),
                        compilation_options: options(&constants),
                        buffers: &[],
                    },
                    primitive: wgpu::PrimitiveState::default(),
                    depth_stencil,
                    multisample: wgpu::MultisampleState::default(),
                    fragment: Some(wgpu::FragmentState {
                        module,
                        entry_point: Some("fragment_main"),
                        compilation_options: options(&constants),
                        targets,
                    }),
                    multiview_mask: None,
                    cache: None,
                })
            })?;
            self.render.insert(key.clone(), pipeline);
        }
        let groups = gpu.guarded(label, || bind_groups(gpu, plan, objects, program, &layouts))?;
        Ok(Ready::Draw(self.render[&key].clone(), groups))
    }
}

fn depth_state(reversed: bool) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: wgpu::TextureFormat::Depth32Float,
        depth_write_enabled: Some(true),
        depth_compare: Some(if reversed {
            wgpu::CompareFunction::Greater
        } else {
            wgpu::CompareFunction::Less
        }),
        stencil: wgpu::StencilState::default(),
        // Shadow maps lie a little behind the surfaces that cast them, more where those are steep.
        bias: if reversed {
            wgpu::DepthBiasState::default()
        } else {
            wgpu::DepthBiasState { constant: 16, slope_scale: 2.0, clamp: 0.0 }
        },
    }
}

fn constants(program: &Program) -> Vec<(&str, f64)> {
    program.constants.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

fn options<'a>(constants: &'a [(&'a str, f64)]) -> wgpu::PipelineCompilationOptions<'a> {
    // Buffers are zeroed by their clears; workgroup memory is written before it is read.
    wgpu::PipelineCompilationOptions { constants, zero_initialize_workgroup_memory: false }
}

fn pipeline_layout(gpu: &Gpu, layouts: &[Option<wgpu::BindGroupLayout>]) -> wgpu::PipelineLayout {
    let layouts: Vec<_> = layouts.iter().map(Option::as_ref).collect();
    gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &layouts,
        immediate_size: 0,
    })
}

fn group_count(program: &Program) -> u32 {
    program.binds.iter().map(|bind| bind.group + 1).max().unwrap_or(0)
}

fn layouts(
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
        _ => wgpu::TextureFormat::Rgba16Float,
    }
}

/// What a bind group holds; kept while it is made.
enum Held {
    Buffer(wgpu::Buffer),
    View(wgpu::TextureView),
    Sampler(wgpu::Sampler),
}

fn bind_groups(
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
        Target::Resource(index) => match &objects[*index] {
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
