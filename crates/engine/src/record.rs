//! A pass's steps as commands.

use voxlume_graph::{Groups, Step, Vertices};

use crate::bind::{BindGroups, Bound};
use crate::program::Pipeline;
use crate::resources::{Object, Resources};
use crate::scene::SceneObjects;
use crate::timing::Queries;

/// Texels along a side of the square that a workgroup of a pass over an image covers.
const TILE: u32 = 8;

/// What commands are made of.
#[derive(Clone, Copy)]
pub(crate) struct Recorder<'a> {
    pub scene: &'a SceneObjects,
    pub resources: &'a Resources,
    /// Names the pass.
    pub label: &'a str,
}

impl Recorder<'_> {
    /// Records steps; those that have a program are bound. `queries` take the time of the pass with this number.
    pub fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        steps: &[Step],
        bound: &[Option<Bound>],
        queries: Option<(&Queries, u32)>,
    ) {
        // Runs of dispatches share a compute pass; the first and the last pass of all carry the timestamps.
        let runs = runs(steps);
        let timed =
            |run: &std::ops::Range<usize>| !matches!(steps[run.start], Step::Clear(_) | Step::Copy { .. });
        let (first, last) = (runs.iter().position(timed), runs.iter().rposition(timed));
        for (number, run) in runs.iter().enumerate() {
            let ends = (Some(number) == first, Some(number) == last);
            match &steps[run.start] {
                Step::Clear(resource) => {
                    if let Some(buffer) = self.resources.buffer(*resource) {
                        encoder.clear_buffer(buffer, 0, None);
                    }
                }
                Step::Copy { from, to } => {
                    if let (Some(from), Some(to)) = (self.resources.buffer(*from), self.resources.buffer(*to))
                    {
                        encoder.copy_buffer_to_buffer(from, 0, to, 0, from.size().min(to.size()));
                    }
                }
                Step::Counted => {}
                Step::Compute { .. } => {
                    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                        label: Some(self.label),
                        timestamp_writes: queries.and_then(|(q, index)| q.compute(index, ends)),
                    });
                    for index in run.clone() {
                        self.dispatch(&mut pass, &steps[index], &bound[index]);
                    }
                }
                Step::Raster { target, vertices, .. } => {
                    let writes = queries.and_then(|(q, index)| q.render(index, ends));
                    self.raster(encoder, *target, *vertices, &bound[run.start], writes);
                }
                Step::Draw { colors, depth, reversed, .. } => {
                    let writes = queries.and_then(|(q, index)| q.render(index, ends));
                    self.draw(encoder, colors, *depth, *reversed, &bound[run.start], writes);
                }
            }
        }
    }

    fn ready<'b>(&self, bound: &'b Option<Bound>) -> Option<(&'b Pipeline, &'b BindGroups)> {
        let (pipeline, groups) = bound.as_ref()?.ready(self.resources);
        Some((pipeline, groups?))
    }

    fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, step: &Step, bound: &Option<Bound>) {
        let (Step::Compute { groups, .. }, Some((Pipeline::Compute(pipeline), bind_groups))) =
            (step, self.ready(bound))
        else {
            return;
        };
        pass.set_pipeline(pipeline);
        for (index, group) in used(bind_groups) {
            pass.set_bind_group(index, group, &[]);
        }
        match groups {
            Groups::Fixed([x, y, z]) => pass.dispatch_workgroups(*x, *y, *z),
            Groups::Tiles { image, quads, layers } => {
                if let Some(texture) = self.resources.texture(*image) {
                    let groups = |side: u32| if *quads { side / 2 + 1 } else { side }.div_ceil(TILE);
                    let layers = layers.unwrap_or(texture.depth_or_array_layers());
                    pass.dispatch_workgroups(groups(texture.width()), groups(texture.height()), layers);
                }
            }
            Groups::Indirect { resource, offset } => {
                if let Some(buffer) = self.resources.buffer(*resource) {
                    pass.dispatch_workgroups_indirect(buffer, *offset);
                }
            }
        }
    }

    fn raster(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: usize,
        vertices: Vertices,
        bound: &Option<Bound>,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let (Some(texture), Some((Pipeline::Render(pipeline), bind_groups))) =
            (self.resources.texture(target), self.ready(bound))
        else {
            return;
        };
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let ops = wgpu::Operations {
            load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
            store: wgpu::StoreOp::Discard,
        };
        let attachment =
            wgpu::RenderPassColorAttachment { view: &view, depth_slice: None, resolve_target: None, ops };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(self.label),
            color_attachments: &[Some(attachment)],
            timestamp_writes,
            ..Default::default()
        });
        set(&mut pass, pipeline, bind_groups);
        match vertices {
            Vertices::Fixed(count) => pass.draw(0..count, 0..1),
            Vertices::Indirect { resource, offset } => {
                if let Some(buffer) = self.resources.buffer(resource) {
                    pass.draw_indirect(buffer, offset);
                }
            }
        }
    }

    fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        colors: &[Option<usize>],
        (depth, layer): (usize, u32),
        reversed: bool,
        bound: &Option<Bound>,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let view = |index: usize, layer: u32| match self.resources.newest(index) {
            Object::Texture(texture) => Some(texture.create_view(&wgpu::TextureViewDescriptor {
                dimension: Some(wgpu::TextureViewDimension::D2),
                mip_level_count: Some(1),
                base_array_layer: layer,
                array_layer_count: Some(1),
                ..Default::default()
            })),
            _ => None,
        };
        let views: Vec<_> = colors.iter().map(|color| color.and_then(|index| view(index, 0))).collect();
        let (Some(depth_view), Some((Pipeline::Render(pipeline), bind_groups))) =
            (view(depth, layer), self.ready(bound))
        else {
            return;
        };
        let attachments: Vec<_> = views
            .iter()
            .map(|view| {
                let ops = wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                };
                view.as_ref().map(|view| wgpu::RenderPassColorAttachment {
                    view,
                    depth_slice: None,
                    resolve_target: None,
                    ops,
                })
            })
            .collect();
        let clear = wgpu::LoadOp::Clear(if reversed { 0.0 } else { 1.0 });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(self.label),
            color_attachments: &attachments,
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth_view,
                depth_ops: Some(wgpu::Operations { load: clear, store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            timestamp_writes,
            ..Default::default()
        });
        set(&mut pass, pipeline, bind_groups);
        pass.set_index_buffer(self.scene.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.scene.index_count, 0, 0..1);
    }
}

fn set(pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline, bind_groups: &BindGroups) {
    pass.set_pipeline(pipeline);
    for (index, group) in used(bind_groups) {
        pass.set_bind_group(index, group, &[]);
    }
}

fn used(groups: &BindGroups) -> impl Iterator<Item = (u32, &wgpu::BindGroup)> {
    groups.iter().enumerate().filter_map(|(index, group)| Some((index as u32, group.as_ref()?)))
}

/// Steps that go into one pass of the encoder together.
fn runs(steps: &[Step]) -> Vec<std::ops::Range<usize>> {
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    for (index, step) in steps.iter().enumerate() {
        let joins = matches!(step, Step::Compute { .. })
            && runs.last().is_some_and(|run| matches!(steps[run.start], Step::Compute { .. }));
        match runs.last_mut() {
            Some(run) if joins => run.end = index + 1,
            _ if matches!(step, Step::Counted) => {}
            _ => runs.push(index..index + 1),
        }
    }
    runs
}
