//! Programs as pipelines, each made once and kept by content.

use std::collections::HashMap;

use voxlume_graph::{ImageTexel, Plan, Program, ResourceKind, Step};

use crate::Error;
use crate::host::Host;
use crate::layout::{Layouts, layouts};
use crate::resources::{RASTER_FORMAT, image_format};

/// Shader modules by their text, and pipelines by all that they are made of. Another plan finds here what it shares with
/// the ones before it.
#[derive(Debug, Default)]
pub(crate) struct Programs {
    /// With a number that is shorter than the text.
    modules: HashMap<String, (usize, wgpu::ShaderModule)>,
    pipelines: HashMap<String, Compiled>,
}

/// A pipeline and the layouts of its bind groups.
#[derive(Clone, Debug)]
pub(crate) struct Compiled {
    pub pipeline: Pipeline,
    pub layouts: Layouts,
}

#[derive(Clone, Debug)]
pub(crate) enum Pipeline {
    Compute(wgpu::ComputePipeline),
    Render(wgpu::RenderPipeline),
}

/// What a program that draws draws on.
#[derive(Debug)]
struct Targets {
    colors: Vec<Option<wgpu::ColorTargetState>>,
    depth: Option<wgpu::DepthStencilState>,
}

impl Programs {
    /// A step's program; `None` for a step without one. `label` names its pass.
    ///
    /// # Errors
    /// The device refuses a shader or a pipeline.
    pub fn compiled(
        &mut self,
        host: &mut Host,
        plan: &Plan,
        label: &str,
        step: &Step,
    ) -> Result<Option<Compiled>, Error> {
        let (program, targets) = match step {
            Step::Clear(_) | Step::Copy { .. } | Step::Counted => return Ok(None),
            Step::Compute { program, .. } => (program, None),
            Step::Draw { program, colors, reversed, .. } => (program, Some(drawn(plan, colors, *reversed))),
            Step::Raster { program, .. } => (program, Some(rastered())),
        };
        let (number, module) = self.module(host, &plan.shaders[program.shader].wgsl)?;
        // A layout follows from what the program binds.
        let binds: Vec<_> = program.binds.iter().map(|bind| (bind.group, bind.binding, &bind.kind)).collect();
        let key = format!("{number} {} {:?} {binds:?} {targets:?}", program.entry, program.constants);
        if let Some(known) = self.pipelines.get(&key) {
            return Ok(Some(known.clone()));
        }
        host.counters.pipelines += 1;
        let made = host.gpu.guarded(label, || match &targets {
            None => compute(&host.gpu.device, label, &module, program),
            Some(targets) => render(&host.gpu.device, label, &module, program, targets),
        })?;
        self.pipelines.insert(key, made.clone());
        Ok(Some(made))
    }

    fn module(&mut self, host: &mut Host, wgsl: &str) -> Result<(usize, wgpu::ShaderModule), Error> {
        if let Some(known) = self.modules.get(wgsl) {
            return Ok(known.clone());
        }
        host.counters.modules += 1;
        let made = host.gpu.guarded("a shader", || {
            host.gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: None,
                source: wgpu::ShaderSource::Wgsl(wgsl.into()),
            })
        })?;
        let numbered = (self.modules.len(), made);
        self.modules.insert(wgsl.to_owned(), numbered.clone());
        Ok(numbered)
    }
}

fn compute(device: &wgpu::Device, label: &str, module: &wgpu::ShaderModule, program: &Program) -> Compiled {
    let layouts = layouts(device, program, wgpu::ShaderStages::COMPUTE);
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(label),
        layout: Some(&pipeline_layout(device, &layouts)),
        module,
        entry_point: Some(program.entry),
        compilation_options: options(&constants(program)),
        cache: None,
    });
    Compiled { pipeline: Pipeline::Compute(pipeline), layouts }
}

fn render(
    device: &wgpu::Device,
    label: &str,
    module: &wgpu::ShaderModule,
    program: &Program,
    targets: &Targets,
) -> Compiled {
    let layouts = layouts(device, program, wgpu::ShaderStages::VERTEX_FRAGMENT);
    let constants = constants(program);
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(label),
        layout: Some(&pipeline_layout(device, &layouts)),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("vertex_main"),
            compilation_options: options(&constants),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: targets.depth.clone(),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some("fragment_main"),
            compilation_options: options(&constants),
            targets: &targets.colors,
        }),
        multiview_mask: None,
        cache: None,
    });
    Compiled { pipeline: Pipeline::Render(pipeline), layouts }
}

/// Triangles onto images of the plan.
fn drawn(plan: &Plan, colors: &[Option<usize>], reversed: bool) -> Targets {
    let color = |index: usize| {
        let ResourceKind::Image { texel, .. } = plan.resources[index].kind else { return None };
        Some(wgpu::ColorTargetState::from(image_format(texel)))
    };
    let compare = if reversed { wgpu::CompareFunction::Greater } else { wgpu::CompareFunction::Less };
    let depth = wgpu::DepthStencilState {
        format: image_format(ImageTexel::Depth32),
        depth_write_enabled: Some(true),
        depth_compare: Some(compare),
        stencil: wgpu::StencilState::default(),
        // Shadow maps lie a little behind the surfaces that cast them, more where those are steep.
        bias: if reversed {
            wgpu::DepthBiasState::default()
        } else {
            wgpu::DepthBiasState { constant: 16, slope_scale: 2.0, clamp: 0.0 }
        },
    };
    Targets { colors: colors.iter().map(|index| index.and_then(color)).collect(), depth: Some(depth) }
}

/// Fragments that write to buffers only.
fn rastered() -> Targets {
    let unwritten =
        wgpu::ColorTargetState { format: RASTER_FORMAT, blend: None, write_mask: wgpu::ColorWrites::empty() };
    Targets { colors: vec![Some(unwritten)], depth: None }
}

fn constants(program: &Program) -> Vec<(&str, f64)> {
    program.constants.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

fn options<'a>(constants: &'a [(&'a str, f64)]) -> wgpu::PipelineCompilationOptions<'a> {
    // Buffers are zeroed by their clears; workgroup memory is written before it is read.
    wgpu::PipelineCompilationOptions { constants, zero_initialize_workgroup_memory: false }
}

fn pipeline_layout(device: &wgpu::Device, layouts: &Layouts) -> wgpu::PipelineLayout {
    let layouts: Vec<_> = layouts.iter().map(Option::as_ref).collect();
    device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &layouts,
        immediate_size: 0,
    })
}
