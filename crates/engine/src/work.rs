//! A plan on a device: its programs, its resources, and what is known of them from frame to frame.

use voxlume_graph::{Plan, Resource, ResourceKind};

use crate::Error;
use crate::bind::Bound;
use crate::counts::{Counts, counted};
use crate::filler::Fillers;
use crate::host::Host;
use crate::program::Programs;
use crate::record::Recorder;
use crate::resources::Resources;
use crate::scene::SceneObjects;
use crate::schedule::Schedule;
use crate::timing::Queries;

/// See the module.
#[derive(Debug)]
pub(crate) struct Work {
    pub plan: Plan,
    pub resources: Resources,
    pub schedule: Schedule,
    pub counts: Counts,
    /// Frames since histories were emptied.
    pub frame: u32,
    /// By pass and step; `None` for what is no program.
    bound: Vec<Vec<Option<Bound>>>,
}

impl Work {
    pub fn new(
        host: &mut Host,
        programs: &mut Programs,
        plan: Plan,
        scene: &SceneObjects,
    ) -> Result<Work, Error> {
        let mut bound = Vec::new();
        for pass in &plan.passes {
            let mut of_pass = Vec::new();
            for step in &pass.steps {
                let compiled = programs.compiled(host, &plan, &pass.name, step)?;
                let of_step = compiled.zip(step.program());
                of_pass.push(of_step.map(|(made, program)| Bound::new(made, program, &plan.resources)));
            }
            bound.push(of_pass);
        }
        let resources = Resources::new(host, &plan, |name| scene.object(name))?;
        let (schedule, counts) = (Schedule::new(&plan), Counts::new(&plan));
        Ok(Work { plan, resources, schedule, counts, frame: 0, bound })
    }

    /// Takes over the scene's buffers and textures, of which some are others now.
    pub fn attach(&mut self, scene: &SceneObjects) {
        let is_scene = |resource: &Resource| resource.kind == ResourceKind::Scene;
        let all = self.of_plan(is_scene);
        for index in &all {
            if let Some(object) = scene.object(&self.plan.resources[*index].name) {
                self.resources.put(*index, object);
            }
        }
        self.release(&all);
    }

    /// Voxelizes up to the counts of voxels, waits for them, and makes the buffers that depend on them.
    pub fn count(
        &mut self,
        host: &mut Host,
        fillers: &mut Fillers,
        scene: &SceneObjects,
    ) -> Result<(), Error> {
        let mut encoder = host.gpu.device.create_command_encoder(&Default::default());
        for pass in 0..self.plan.passes.len() {
            if let Some(end) = counted(&self.plan.passes[pass]) {
                self.steps(host, fillers, scene, &mut encoder, pass, end, None)?;
            }
        }
        host.gpu.guarded("counting voxels", || host.gpu.queue.submit([encoder.finish()]))?;
        self.counts.read(host, &self.plan, &self.resources)?;
        self.counts.room = self.counts.roomy(&self.plan)?;
        self.remake(host, |resource| {
            matches!(resource.kind, ResourceKind::PerVoxel(_) | ResourceKind::PerCell(_))
        })
    }

    /// Records a pass.
    pub fn record(
        &mut self,
        host: &mut Host,
        fillers: &mut Fillers,
        scene: &SceneObjects,
        encoder: &mut wgpu::CommandEncoder,
        pass: usize,
        queries: Option<&Queries>,
    ) -> Result<(), Error> {
        let outputs = &self.plan.passes[pass].outputs;
        outputs.iter().for_each(|output| self.resources.turn(*output));
        let end = self.plan.passes[pass].steps.len();
        let recorded = self.steps(host, fillers, scene, encoder, pass, end, queries);
        match recorded {
            Ok(()) => self.schedule.ran(pass),
            // The encoder won't be submitted, with what it holds of other passes.
            Err(_) => self.schedule.forget_all(),
        }
        host.counters.passes += u64::from(recorded.is_ok());
        recorded
    }

    #[expect(clippy::too_many_arguments, reason = "a device, a scene, and which steps of which pass")]
    fn steps(
        &mut self,
        host: &mut Host,
        fillers: &mut Fillers,
        scene: &SceneObjects,
        encoder: &mut wgpu::CommandEncoder,
        pass: usize,
        end: usize,
        queries: Option<&Queries>,
    ) -> Result<(), Error> {
        let Work { plan, resources, bound, .. } = self;
        let label = plan.passes[pass].name.as_str();
        let steps = &plan.passes[pass].steps[..end];
        for (step, bound) in steps.iter().zip(&mut bound[pass]) {
            if let Some((bound, program)) = bound.as_mut().zip(step.program()) {
                bound.prepare(host, fillers, resources, label, program)?;
            }
        }
        let recorder = Recorder { scene, resources, label };
        recorder.record(encoder, steps, &bound[pass], queries.map(|queries| (queries, pass as u32)));
        Ok(())
    }

    /// See [`crate::Session::settle`].
    pub fn settle(&mut self, host: &mut Host) -> Result<bool, Error> {
        if !self.counts.arrived(&host.gpu, &self.plan)? || !self.counts.outgrown() {
            return Ok(false);
        }
        // What the frame left in buffers that were too small is of no use, nor what was made of it.
        self.schedule.forget_all();
        let room = self.counts.roomy(&self.plan)?;
        let was = std::mem::replace(&mut self.counts.room, room);
        let is_made =
            |resource: &Resource| !matches!(resource.kind, ResourceKind::Scene | ResourceKind::Uniform(_));
        self.remake(host, is_made).inspect_err(|_| self.counts.room = was)?;
        Ok(true)
    }

    /// Makes those resources anew for which `which` holds, or none of them.
    pub fn remake(&mut self, host: &mut Host, which: impl Fn(&Resource) -> bool) -> Result<(), Error> {
        let (voxels, cells) = self.counts.room;
        let bytes = self.plan.total_bytes(voxels, cells);
        if let Some(budget) = self.plan.memory_budget.filter(|budget| bytes > *budget) {
            return Err(Error::OverBudget { bytes, voxels, budget });
        }
        let which = self.of_plan(which);
        self.resources.remake(host, &self.plan, &which, (voxels, cells))?;
        self.release(&which);
        which.iter().for_each(|index| self.schedule.forget(*index));
        self.frame = 0;
        Ok(())
    }

    fn of_plan(&self, which: impl Fn(&Resource) -> bool) -> Vec<usize> {
        let all = self.plan.resources.iter().enumerate();
        all.filter(|(_, resource)| which(resource)).map(|(index, _)| index).collect()
    }

    /// Drops bind groups that hold one of these.
    fn release(&mut self, remade: &[usize]) {
        for (pass, bound) in self.plan.passes.iter().zip(&mut self.bound) {
            for (step, bound) in pass.steps.iter().zip(bound) {
                if let Some((bound, program)) = bound.as_mut().zip(step.program()) {
                    bound.release(program, remade);
                }
            }
        }
    }
}
