//! Programs as pipelines, each made once.

use std::collections::HashMap;

use voxlume_graph::{Plan, Program, ResourceKind};

use crate::bind::{BindGroups, bind_groups, layouts};
use crate::resources::{Object, RASTER_FORMAT, image_format};
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
