//! Carries out a plan, frame after frame.

use std::time::Instant;

use voxlume_graph::{Plan, ResourceKind, SceneFacts, Step};
use voxlume_scene::{Camera, Scene};

use crate::program::{Programs, Ready};
use crate::resources::{Object, SceneObjects, create};
use crate::timing::{Clock, PassTime, Queries};
use crate::upload::frame::{Camera as CameraBytes, Clock as ClockBytes, Environment};
use crate::{Error, Gpu};

/// A scene on a device, ready to be seen.
pub struct Renderer<'g> {
    pub(crate) gpu: &'g Gpu,
    pub(crate) plan: Plan,
    facts: SceneFacts,
    pub(crate) scene: SceneObjects,
    pub(crate) objects: Vec<Object>,
    /// By pass and step; `None` for what is no program.
    ready: Vec<Vec<Option<Ready>>>,
    programs: Programs,
    queries: Option<Queries>,
    pub(crate) counts: (u64, u64),
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

impl<'g> Renderer<'g> {
    /// Uploads the scene, makes the plan's resources and compiles its programs. Voxelizes once to learn how much
    /// memory the occupied voxels need.
    ///
    /// # Errors
    /// The scene isn't what it has to be ([`Scene::check`]), or the device refuses something or is lost.
    pub fn new(gpu: &'g Gpu, plan: Plan, scene: &Scene) -> Result<Renderer<'g>, Error> {
        let facts = SceneFacts::of(scene)?;
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
        let camera = CameraBytes::new(&self.plan, camera);
        let environment = Environment { sky: scene.sky, light_count: self.scene.light_count };
        let write = |buffer, bytes: &[u8]| self.gpu.queue.write_buffer(buffer, 0, bytes);
        write(&self.scene.camera, bytemuck::bytes_of(&camera));
        write(&self.scene.environment, bytemuck::bytes_of(&environment));
        write(&self.scene.clock, bytemuck::bytes_of(&ClockBytes::new(0.0, 0)));
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
        self.plan.passes.iter().any(|pass| pass.sources.geometry && counted(pass))
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
            .filter(|index| passes == Passes::All || !self.warm || !is_once(&self.plan.passes[*index]))
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
}

/// Whether nothing that it depends on can change.
fn is_once(pass: &voxlume_graph::Pass) -> bool {
    pass.sources == Default::default() && pass.name.contains("voxelize")
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
