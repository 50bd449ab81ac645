//! Carries out a plan, frame after frame.

use std::time::Instant;

use voxlume_graph::{Groups, Plan, ResourceKind, SceneFacts, Step, Vertices};
use voxlume_scene::{Camera, Scene};

use crate::image::Picture;
use crate::program::{BindGroups, Programs, Ready};
use crate::resources::{Object, SceneObjects, create};
use crate::timing::{Clock, PassTime, Queries};
use crate::upload::frame::Frame;
use crate::{Error, Gpu, image};

/// A scene on a device, ready to be seen.
pub struct Renderer<'g> {
    pub(crate) gpu: &'g Gpu,
    plan: Plan,
    facts: SceneFacts,
    scene: SceneObjects,
    pub(crate) objects: Vec<Object>,
    /// By pass and step; `None` for what is no program.
    ready: Vec<Vec<Option<Ready>>>,
    programs: Programs,
    queries: Option<Queries>,
    counts: (u64, u64),
    /// What the buffers that depend on these counts were made for.
    capacity: (u64, u64),
    /// Whether passes that run once have run.
    warm: bool,
}

impl std::fmt::Debug for Renderer<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Renderer").field("counts", &self.counts).finish_non_exhaustive()
    }
}

/// Which passes a frame runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passes {
    /// Those whose result may have changed since the last frame.
    Changed,
    /// All of them, also those that would have to run only once: for timing.
    All,
}

/// Values that an encoding could not hold and clamped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// How many texels had one.
    pub values: u32,
    /// The largest, without its sign.
    pub worst: f32,
    /// The largest that the encoding holds.
    pub range: f32,
}

impl std::fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let OutOfRange { values, worst, range } = self;
        write!(
            f,
            "{values} texels out of the encoding's range of {range} were clamped; the largest value is {worst}"
        )
    }
}

impl<'g> Renderer<'g> {
    /// Uploads the scene, makes the plan's resources and compiles its programs. Voxelizes once to learn how much
    /// memory the occupied voxels need.
    ///
    /// # Errors
    /// The device refuses something or is lost.
    pub fn new(gpu: &'g Gpu, plan: Plan, scene: &Scene) -> Result<Renderer<'g>, Error> {
        let facts = SceneFacts::of(scene);
        let uploaded = SceneObjects::new(gpu, &plan, &facts, scene)?;
        let mut objects = Vec::new();
        for (index, resource) in plan.resources.iter().enumerate() {
            let known =
                uploaded.named.iter().find(|(name, _)| *name == resource.name).map(
                    |(_, object)| match object {
                        Object::Buffer(buffer) => Object::Buffer(buffer.clone()),
                        Object::Texture(texture) => Object::Texture(texture.clone()),
                        Object::Sampler(sampler) => Object::Sampler(sampler.clone()),
                        Object::Pending => Object::Pending,
                    },
                );
            objects.push(match known {
                Some(object) if resource.kind == ResourceKind::Scene => object,
                _ => create(gpu, &plan, index, None)?,
            });
        }
        let programs = Programs::new(gpu, &plan)?;
        let queries = gpu.has_reliable_timestamps().then(|| Queries::new(gpu, plan.passes.len() as u32));
        let mut renderer = Renderer {
            gpu,
            plan,
            facts,
            scene: uploaded,
            objects,
            ready: Vec::new(),
            programs,
            queries,
            counts: (0, 0),
            capacity: (0, 0),
            warm: false,
        };
        let camera = scene.cameras.first().cloned();
        if let Some(camera) = &camera {
            renderer.write_frame(scene, camera);
        }
        renderer.count()?;
        renderer.prepare()?;
        Ok(renderer)
    }

    /// The plan that it carries out.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Occupied voxels, and occupied cells of all levels.
    pub fn counts(&self) -> (u64, u64) {
        self.counts
    }

    fn write_frame(&self, scene: &Scene, camera: &Camera) {
        let frame = Frame::new(&self.plan, &self.facts, scene, camera, self.scene.light_count);
        self.gpu.queue.write_buffer(&self.scene.frame, 0, bytemuck::bytes_of(&frame));
    }

    /// Runs voxelization up to the counts of cells, and makes the buffers that depend on them.
    fn count(&mut self) -> Result<(), Error> {
        let counted =
            |pass: &voxlume_graph::Pass| pass.steps.iter().position(|step| matches!(step, Step::Counted));
        let passes = self.plan.passes.iter().filter_map(|pass| Some((pass, counted(pass)?)));
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        for (pass, end) in passes {
            let steps = &pass.steps[..end];
            let ready = steps
                .iter()
                .map(|step| ready(self.gpu, &self.plan, &self.objects, &mut self.programs, &pass.name, step));
            let ready = ready.collect::<Result<Vec<_>, _>>()?;
            self.encode(&mut encoder, steps, &ready, None);
        }
        self.gpu.guarded("counting voxels", || self.gpu.queue.submit([encoder.finish()]))?;
        self.counts = self.read_counts()?;
        self.capacity = self.roomy()?;
        for index in 0..self.objects.len() {
            if matches!(self.plan.resources[index].kind, ResourceKind::PerVoxel(_) | ResourceKind::PerCell(_))
            {
                self.objects[index] = create(self.gpu, &self.plan, index, Some(self.capacity))?;
            }
        }
        Ok(())
    }

    /// Occupied voxels, and occupied cells of all levels, as voxelization last left them.
    fn read_counts(&self) -> Result<(u64, u64), Error> {
        let Some(bytes) = self.buffer("levels")? else { return Ok((0, 0)) };
        // A `LevelRun` is eight words: three of workgroups, the first cell, the count.
        let words: Vec<u32> =
            bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        let count = |level: usize| u64::from(words[level * 8 + 4]);
        Ok((count(0), (0..words.len() / 8).map(count).sum()))
    }

    /// Whether voxels come and go from frame to frame.
    fn voxels_move(&self) -> bool {
        let counted =
            |pass: &voxlume_graph::Pass| pass.steps.iter().any(|step| matches!(step, Step::Counted));
        self.plan.passes.iter().any(|pass| !pass.once && counted(pass))
    }

    /// The counts, with a quarter more where they change from frame to frame, if the plan's budget has room for them.
    fn roomy(&self) -> Result<(u64, u64), Error> {
        let more = |count: u64| if self.voxels_move() { count + count / 4 + 256 } else { count };
        let (voxels, cells) = (more(self.counts.0), more(self.counts.1));
        let bytes = self.plan.total_bytes(voxels, cells);
        match self.plan.memory_budget {
            Some(budget) if bytes > budget => Err(Error::OverBudget { bytes, voxels, budget }),
            _ => Ok((voxels, cells)),
        }
    }

    /// Where the last frame had more voxels than its buffers hold, makes all resources anew, larger: what the frame left in
    /// them is of no use.
    fn outgrown(&mut self) -> Result<bool, Error> {
        if !self.voxels_move() {
            return Ok(false);
        }
        self.counts = self.read_counts()?;
        if self.counts.0 <= self.capacity.0 && self.counts.1 <= self.capacity.1 {
            return Ok(false);
        }
        self.capacity = self.roomy()?;
        for index in 0..self.objects.len() {
            if self.plan.resources[index].kind != ResourceKind::Scene {
                self.objects[index] = create(self.gpu, &self.plan, index, Some(self.capacity))?;
            }
        }
        self.prepare()?;
        self.warm = false;
        Ok(true)
    }

    fn prepare(&mut self) -> Result<(), Error> {
        let mut all = Vec::new();
        for pass in &self.plan.passes {
            let steps = pass
                .steps
                .iter()
                .map(|step| ready(self.gpu, &self.plan, &self.objects, &mut self.programs, &pass.name, step));
            all.push(steps.collect::<Result<Vec<_>, _>>()?);
        }
        self.ready = all;
        Ok(())
    }

    /// Takes over where the scene's moving instances and its lights are now; nothing else of it may have changed.
    /// Frames see it from the next one on.
    ///
    /// # Errors
    /// The scene has another number of lights or triangles than it had.
    pub fn update(&mut self, scene: &Scene) -> Result<(), Error> {
        self.scene.update(self.gpu, &self.plan, &self.facts, scene)
    }

    /// Renders a frame and waits for it. The times are those of the passes that ran.
    ///
    /// # Errors
    /// The device refuses something or is lost.
    pub fn render(&mut self, scene: &Scene, camera: &Camera, passes: Passes) -> Result<Vec<PassTime>, Error> {
        self.write_frame(scene, camera);
        loop {
            let times = self.frame(passes)?;
            if !self.outgrown()? {
                return Ok(times);
            }
        }
    }

    fn frame(&mut self, passes: Passes) -> Result<Vec<PassTime>, Error> {
        let chosen: Vec<usize> = (0..self.plan.passes.len())
            .filter(|index| passes == Passes::All || !self.warm || !self.plan.passes[*index].once)
            .collect();
        let times = match &self.queries {
            Some(queries) => {
                let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
                for index in &chosen {
                    let range = Some((queries, *index as u32));
                    self.encode(&mut encoder, &self.plan.passes[*index].steps, &self.ready[*index], range);
                }
                queries.resolve(&mut encoder);
                self.gpu.guarded("the frame", || self.gpu.queue.submit([encoder.finish()]))?;
                let millis = queries.read(self.gpu)?;
                chosen.iter().map(|index| self.time(*index, millis[*index], Clock::Gpu)).collect()
            }
            None => {
                let mut times = Vec::new();
                for index in chosen {
                    let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
                    self.encode(&mut encoder, &self.plan.passes[index].steps, &self.ready[index], None);
                    let start = Instant::now();
                    self.gpu.guarded("the frame", || self.gpu.queue.submit([encoder.finish()]))?;
                    self.gpu.wait()?;
                    times.push(self.time(index, start.elapsed().as_secs_f64() * 1e3, Clock::Wall));
                }
                times
            }
        };
        self.warm = true;
        Ok(times)
    }

    fn time(&self, pass: usize, milliseconds: f64, clock: Clock) -> PassTime {
        PassTime { pass, name: self.plan.passes[pass].name.clone(), milliseconds, clock }
    }

    fn encode(
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
        pass.set_pipeline(pipeline);
        for (index, group) in used(bind_groups) {
            pass.set_bind_group(index, group, &[]);
        }
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
        pass.set_pipeline(pipeline);
        for (index, group) in used(bind_groups) {
            pass.set_bind_group(index, group, &[]);
        }
        pass.set_index_buffer(self.scene.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.scene.index_count, 0, 0..1);
    }

    /// Reads an image of the plan, linear.
    ///
    /// # Errors
    /// The plan has no such image, or the device is lost.
    pub fn picture(&self, name: &str) -> Result<Picture, Error> {
        let found = self.plan.resource(name).and_then(|index| match &self.objects[index] {
            Object::Texture(texture)
                if matches!(self.plan.resources[index].kind, ResourceKind::Image { .. }) =>
            {
                Some(texture)
            }
            _ => None,
        });
        let Some(texture) = found else {
            let images = self.plan.resources.iter().filter(|r| matches!(r.kind, ResourceKind::Image { .. }));
            let known = images.map(|resource| resource.name.clone()).collect();
            return Err(Error::NoSuchImage { name: name.to_owned(), known });
        };
        image::read(self.gpu, texture)
    }

    /// The texture of an image of the plan.
    pub fn texture(&self, name: &str) -> Option<&wgpu::Texture> {
        match &self.objects[self.plan.resource(name)?] {
            Object::Texture(texture) => Some(texture),
            _ => None,
        }
    }

    /// Reads a buffer of the plan, such as `occupancy`.
    ///
    /// # Errors
    /// The device is lost. `None` where the plan has no such buffer.
    pub fn buffer(&self, name: &str) -> Result<Option<Vec<u8>>, Error> {
        let Some(Object::Buffer(buffer)) = self.plan.resource(name).map(|index| &self.objects[index]) else {
            return Ok(None);
        };
        let read = self.gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read"),
            size: buffer.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &read, 0, buffer.size());
        self.gpu.guarded("reading a buffer", || self.gpu.queue.submit([encoder.finish()]))?;
        self.gpu.read(&read).map(Some)
    }

    /// What the volume's encoding could not hold in the last frame; `None` where it could hold everything.
    ///
    /// # Errors
    /// The device is lost.
    pub fn out_of_range(&self) -> Result<Option<OutOfRange>, Error> {
        let Some(bytes) = self.buffer("out_of_range")? else { return Ok(None) };
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        let (values, worst) = (word(0), f32::from_bits(word(4)));
        Ok((values > 0).then_some(OutOfRange { values, worst, range: self.plan.encoding.range() }))
    }

    /// Bytes of each of the plan's resources.
    pub fn bytes(&self) -> Vec<(String, u64)> {
        let (voxels, cells) = self.counts;
        let size = |index: usize| match &self.objects[index] {
            Object::Buffer(buffer) => Some(buffer.size()),
            Object::Texture(texture) if self.plan.resources[index].kind == ResourceKind::Scene => {
                Some(image::texture_bytes(texture))
            }
            _ => self.plan.bytes(index, voxels, cells),
        };
        let resources = self.plan.resources.iter().enumerate();
        resources.filter_map(|(index, resource)| Some((resource.name.clone(), size(index)?))).collect()
    }
}

/// A step's program, bound; `None` for what is no program.
fn ready(
    gpu: &Gpu,
    plan: &Plan,
    objects: &[Object],
    programs: &mut Programs,
    label: &str,
    step: &Step,
) -> Result<Option<Ready>, Error> {
    Ok(match step {
        Step::Clear(_) | Step::Copy { .. } | Step::Counted => None,
        Step::Compute { program, .. } => Some(programs.compute(gpu, plan, objects, label, program)?),
        Step::Raster { program, .. } => Some(programs.raster(gpu, plan, objects, label, program)?),
        Step::Draw { program, colors, reversed, .. } => {
            Some(programs.draw(gpu, plan, objects, label, program, colors, *reversed)?)
        }
    })
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
