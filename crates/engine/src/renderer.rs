//! Frames that are waited for, one at a time, and timed.

use std::time::Instant;

use voxlume_graph::Plan;
use voxlume_scene::{Camera, Scene};

use crate::frame::{Frame, Passes};
use crate::session::Session;
use crate::timing::{Clock, PassTime, Queries};
use crate::{Error, Gpu};

/// A session whose frames are submitted, timed and waited for, so that what they made can be read back.
#[derive(Debug)]
pub struct Renderer<'g> {
    pub(crate) gpu: &'g Gpu,
    pub(crate) session: Session,
    queries: Option<Queries>,
}

impl<'g> Renderer<'g> {
    /// As [`Session::new`].
    ///
    /// # Errors
    /// As [`Session::new`].
    pub fn new(gpu: &'g Gpu, plan: Plan, scene: &Scene) -> Result<Renderer<'g>, Error> {
        Ok(Renderer { gpu, session: Session::new(gpu, plan, scene)?, queries: None })
    }

    /// The session behind it.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The session behind it, to resize it, to set parameters or to plan anew.
    pub fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The plan that it carries out.
    pub fn plan(&self) -> &Plan {
        self.session.plan()
    }

    /// Occupied voxels, and occupied cells of all levels.
    pub fn counts(&self) -> (u64, u64) {
        self.session.counts()
    }

    /// As [`Session::update`].
    ///
    /// # Errors
    /// As [`Session::update`].
    pub fn update(&mut self, scene: &Scene) -> Result<(), Error> {
        self.session.update(scene)
    }

    /// Renders a frame of the scene as it is now and waits for it. The times are those of the passes that ran.
    ///
    /// # Errors
    /// As [`Session::update`] and [`Session::encode`].
    pub fn render(&mut self, scene: &Scene, camera: &Camera, passes: Passes) -> Result<Vec<PassTime>, Error> {
        self.session.update(scene)?;
        self.frame(&Frame { passes, ..Frame::of(camera) })
    }

    /// Renders a frame and waits for it. The times are those of the passes that ran.
    ///
    /// # Errors
    /// As [`Session::encode`].
    pub fn frame(&mut self, frame: &Frame<'_>) -> Result<Vec<PassTime>, Error> {
        loop {
            let times = self.attempt(frame)?;
            if !self.session.settle()? {
                return Ok(times);
            }
        }
    }

    fn attempt(&mut self, frame: &Frame<'_>) -> Result<Vec<PassTime>, Error> {
        let passes = self.session.begin(frame)?;
        match self.gpu.has_reliable_timestamps() {
            true => self.timed_by_device(&passes),
            false => self.timed_by_host(&passes),
        }
    }

    fn timed_by_device(&mut self, passes: &[usize]) -> Result<Vec<PassTime>, Error> {
        let count = self.plan().passes.len() as u32;
        let queries = match self.queries.take() {
            Some(queries) if queries.passes() >= count => queries,
            _ => Queries::new(self.gpu, count),
        };
        let mut encoder = self.encoder();
        for pass in passes {
            self.session.record(&mut encoder, *pass, Some(&queries))?;
        }
        self.session.end(&mut encoder, passes)?;
        queries.resolve(&mut encoder);
        self.submit(encoder)?;
        let milliseconds = queries.read(self.gpu)?;
        self.queries = Some(queries);
        Ok(passes.iter().map(|pass| self.time(*pass, milliseconds[*pass], Clock::Gpu)).collect())
    }

    /// A submission for each pass, and a last one for what the session has to say.
    fn timed_by_host(&mut self, passes: &[usize]) -> Result<Vec<PassTime>, Error> {
        let mut times = Vec::new();
        for pass in passes {
            let mut encoder = self.encoder();
            self.session.record(&mut encoder, *pass, None)?;
            let start = Instant::now();
            self.submit(encoder)?;
            self.gpu.wait()?;
            times.push(self.time(*pass, start.elapsed().as_secs_f64() * 1e3, Clock::Wall));
        }
        let mut encoder = self.encoder();
        self.session.end(&mut encoder, passes)?;
        self.submit(encoder)?;
        self.gpu.wait()?;
        Ok(times)
    }

    fn encoder(&self) -> wgpu::CommandEncoder {
        self.gpu.device.create_command_encoder(&Default::default())
    }

    fn submit(&self, encoder: wgpu::CommandEncoder) -> Result<(), Error> {
        self.gpu.guarded("the frame", || self.gpu.queue.submit([encoder.finish()])).map(|_| ())
    }

    fn time(&self, pass: usize, milliseconds: f64, clock: Clock) -> PassTime {
        PassTime { pass, name: self.plan().passes[pass].name.clone(), milliseconds, clock }
    }
}
