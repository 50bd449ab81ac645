//! A pass's steps as commands.

use voxlume_graph::{Groups, Step, Vertices};

use crate::Renderer;
use crate::bind::BindGroups;
use crate::program::Ready;
use crate::resources::Object;
use crate::timing::Queries;

/// Texels along a side of the square that a workgroup of a pass over an image covers.
const TILE: u32 = 8;

impl Renderer<'_> {
    pub(crate) fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        steps: &[Step],
        ready: &[Option<Ready>],
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
                    if let Object::Buffer(buffer) = &self.objects[*resource] {
                        encoder.clear_buffer(buffer, 0, None);
                    }
                }
                Step::Copy { from, to } => {
                    if let (Object::Buffer(from), Object::Buffer(to)) =
                        (&self.objects[*from], &self.objects[*to])
                    {
                        encoder.copy_buffer_to_buffer(from, 0, to, 0, from.size());
                    }
                }
                Step::Counted => {}
                Step::Compute { .. } => {
                    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                        label: None,
                        timestamp_writes: queries.and_then(|(q, index)| q.compute(index, ends)),
                    });
                    for index in run.clone() {
                        self.dispatch(&mut pass, &steps[index], &ready[index]);
                    }
                }
                Step::Raster { target, vertices, .. } => {
                    let writes = queries.and_then(|(q, index)| q.render(index, ends));
                    self.raster(encoder, *target, *vertices, &ready[run.start], writes);
                }
                Step::Draw { colors, depth, reversed, .. } => {
                    let writes = queries.and_then(|(q, index)| q.render(index, ends));
                    self.draw(encoder, colors, *depth, *reversed, &ready[run.start], writes);
                }
            }
        }
    }

    fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>, step: &Step, ready: &Option<Ready>) {
        let (Step::Compute { groups, .. }, Some(Ready::Compute(pipeline, bind_groups))) = (step, ready)
        else {
            return;
        };
        pass.set_pipeline(pipeline);
        for (index, group) in used(bind_groups) {
            pass.set_bind_group(index, group, &[]);
        }
        match groups {
            Groups::Fixed([x, y, z]) => pass.dispatch_workgroups(*x, *y, *z),
            Groups::Tiles(image) => {
                if let Object::Texture(texture) = &self.objects[*image] {
                    let [width, height] = [texture.width(), texture.height()].map(|side| side.div_ceil(TILE));
                    pass.dispatch_workgroups(width, height, texture.depth_or_array_layers());
                }
            }
            Groups::Indirect { resource, offset } => {
                if let Object::Buffer(buffer) = &self.objects[*resource] {
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
        ready: &Option<Ready>,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let (Object::Texture(texture), Some(Ready::Draw(pipeline, bind_groups))) =
            (&self.objects[target], ready)
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
            color_attachments: &[Some(attachment)],
            timestamp_writes,
            ..Default::default()
        });
        set(&mut pass, pipeline, bind_groups);
        match vertices {
            Vertices::Fixed(count) => pass.draw(0..count, 0..1),
            Vertices::Indirect { resource, offset } => {
                if let Object::Buffer(buffer) = &self.objects[resource] {
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
        ready: &Option<Ready>,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let view = |index: usize, layer: u32| match &self.objects[index] {
            Object::Texture(texture) => Some(texture.create_view(&wgpu::TextureViewDescriptor {
                dimension: Some(wgpu::TextureViewDimension::D2),
                base_array_layer: layer,
                array_layer_count: Some(1),
                ..Default::default()
            })),
            _ => None,
        };
        let views: Vec<_> = colors.iter().map(|color| color.and_then(|index| view(index, 0))).collect();
        let (Some(depth_view), Some(Ready::Draw(pipeline, bind_groups))) = (view(depth, layer), ready) else {
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
