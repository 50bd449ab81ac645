//! Frames: what they show, what they run, and how they are recorded.

use voxlume_fault::Fault;
use voxlume_scene::Camera;

use crate::timing::Queries;
use crate::work::Work;
use crate::{Error, Session};

/// What a frame shows, and what it runs.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// From where the scene is seen.
    pub camera: &'a Camera,
    /// The scene's own time, for passes that depend on it.
    pub seconds: f32,
    /// Which passes it runs.
    pub passes: Passes,
    /// Names of passes with `update: on_demand` that run in this frame.
    pub demanded: &'a [&'a str],
}

/// Which passes a frame runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passes {
    /// Those whose result may have changed since the last frame.
    Changed,
    /// All of them: for timing.
    All,
}

impl<'a> Frame<'a> {
    /// What has changed, seen by this camera at the beginning of time.
    pub fn of(camera: &'a Camera) -> Frame<'a> {
        Frame { camera, seconds: 0.0, passes: Passes::Changed, demanded: &[] }
    }
}

impl Session {
    /// Has the next frame run every pass: what was recorded before never came to be.
    pub fn forget(&mut self) {
        self.work.schedule.forget_all();
    }

    /// Records a frame and gives the passes that it runs, by their index in the plan. Neither waits nor submits. Where moving
    /// triangles have come to occupy more voxels than there is memory for, this is known a frame or more later; the memory
    /// is made larger then, and all passes run again.
    ///
    /// # Errors
    /// The camera isn't what it has to be, the time isn't finite, a pass isn't known, voxels have outgrown the plan's budget, or the device
    /// refuses something or is lost. Don't submit the encoder then.
    pub fn encode(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &Frame<'_>,
    ) -> Result<Vec<usize>, Error> {
        let passes = self.begin(frame)?;
        for pass in &passes {
            self.record(encoder, *pass, None)?;
        }
        self.end(encoder, &passes)?;
        Ok(passes)
    }

    /// Writes a frame's uniforms, and gives the passes that it runs.
    pub(crate) fn begin(&mut self, frame: &Frame<'_>) -> Result<Vec<usize>, Error> {
        self.host.gpu.check()?;
        frame.camera.check()?;
        if !frame.seconds.is_finite() {
            return Err(Fault::new(format!("a frame at {} seconds", frame.seconds))
                .note("a finite time")
                .into());
        }
        let plan = &self.work.plan;
        let index = |name: &&str| {
            let found = plan.passes.iter().position(|pass| pass.name == *name);
            found.ok_or_else(|| Error::NoSuchPass {
                name: (*name).to_owned(),
                known: plan.passes.iter().map(|pass| pass.name.clone()).collect(),
            })
        };
        let demanded = frame.demanded.iter().map(index).collect::<Result<Vec<usize>, Error>>()?;
        self.settle()?;
        let Work { plan, schedule, frame: number, .. } = &mut self.work;
        self.scene.look(&mut self.host, plan, frame.camera, &mut schedule.versions);
        if plan.passes.iter().any(|pass| pass.sources.time) {
            self.scene.tick(&mut self.host, frame.seconds, *number);
        }
        *number += 1;
        Ok(schedule.begin(frame.passes == Passes::All, &demanded))
    }

    /// Records a pass; `queries` take its time.
    pub(crate) fn record(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        pass: usize,
        queries: Option<&Queries>,
    ) -> Result<(), Error> {
        let Session { host, scene, fillers, work, .. } = self;
        work.record(host, fillers, scene, encoder, pass, queries)
    }

    /// Ends the recording of these passes.
    pub(crate) fn end(&mut self, encoder: &mut wgpu::CommandEncoder, passes: &[usize]) -> Result<(), Error> {
        let Work { plan, resources, counts, .. } = &mut self.work;
        counts.follow(&mut self.host, encoder, plan, resources, passes)
    }

    /// Takes in how many voxels there are, if this has become known; whether they had outgrown their memory, and the frame
    /// has to be done over.
    pub(crate) fn settle(&mut self) -> Result<bool, Error> {
        self.work.settle(&mut self.host)
    }
}
