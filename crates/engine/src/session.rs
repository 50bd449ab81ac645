//! A scene on a device, and a plan that is carried out on it frame after frame.

use voxlume_graph::{ImageExtent, Life, ParamBytes, Plan, ResourceKind, SceneFacts, Value};
use voxlume_scene::Scene;

use crate::filler::Fillers;
use crate::host::{Counters, Host};
use crate::program::Programs;
use crate::resources::Object;
use crate::scene::SceneObjects;
use crate::work::Work;
use crate::{Error, Gpu};

/// A scene on a device and a plan's programs and resources, ready to be recorded into a frame.
///
/// Whatever is written goes to the device's queue and takes effect with its next submission. So submit an encoder that was
/// given to [`Session::encode`] before you call anything that changes the session again. Its passes count as done from
/// the moment they are recorded: drop such an encoder, and call [`Session::forget`].
#[derive(Debug)]
pub struct Session {
    pub(crate) host: Host,
    facts: SceneFacts,
    pub(crate) scene: SceneObjects,
    programs: Programs,
    pub(crate) fillers: Fillers,
    pub(crate) work: Work,
}

impl Session {
    /// Uploads the scene, makes the plan's resources and compiles its programs. Voxelizes once to learn how much
    /// memory the occupied voxels need, and waits for it.
    ///
    /// # Errors
    /// The scene isn't what it has to be ([`Scene::check`]), the plan is over its budget, or the device refuses something
    /// or is lost.
    pub fn new(gpu: &Gpu, plan: Plan, scene: &Scene) -> Result<Session, Error> {
        let facts = SceneFacts::of(scene)?;
        let mut host = Host::new(gpu);
        let scene = SceneObjects::new(&mut host, &plan, &facts, scene)?;
        let (mut programs, mut fillers) = (Programs::default(), Fillers::default());
        let mut work = Work::new(&mut host, &mut programs, plan, &scene)?;
        work.count(&mut host, &mut fillers, &scene)?;
        Ok(Session { host, facts, scene, programs, fillers, work })
    }

    /// Takes another plan for the same scene: of another format, pipeline or size. Only programs that no plan before it had
    /// are compiled; of the scene, only what depends on the plan is written again. Waits as [`Session::new`] does. The old
    /// plan's memory is freed once the new plan has its own.
    ///
    /// # Errors
    /// As [`Session::new`] and [`Session::update`]. The session then goes on with the plan that it had.
    pub fn replan(&mut self, plan: Plan, scene: &Scene) -> Result<(), Error> {
        let Session { host, facts, scene: objects, programs, fillers, work } = self;
        objects.replan(host, &plan, facts, scene)?;
        let made = Work::new(host, programs, plan, objects);
        let counted = made.and_then(|mut new| new.count(host, fillers, objects).map(|()| new));
        match counted {
            Ok(new) => {
                self.work = new;
                Ok(())
            }
            Err(error) => {
                objects.replan(host, &work.plan, facts, scene)?;
                work.attach(objects);
                work.schedule.forget_all();
                Err(error)
            }
        }
    }

    /// The plan that it carries out, with parameters as they were set.
    pub fn plan(&self) -> &Plan {
        &self.work.plan
    }

    /// Occupied voxels, and occupied cells of all levels, as far as is known without waiting.
    pub fn counts(&self) -> (u64, u64) {
        self.work.counts.occupied
    }

    /// What it has had the device do.
    pub fn counters(&self) -> Counters {
        self.host.counters
    }

    /// The texture of an image or a volume of the plan, as the last frame left it. `resize` and `replan` make others.
    pub fn texture(&self, name: &str) -> Option<&wgpu::Texture> {
        self.work.resources.texture(self.work.plan.resource(name)?)
    }

    /// Takes over where the scene's moving instances and its lights are now, and its sky, as far as it differs.
    ///
    /// # Errors
    /// Something is not finite or out of its range, or the scene differs in more than that. Nothing is taken over then.
    pub fn update(&mut self, scene: &Scene) -> Result<(), Error> {
        let Session { host, facts, scene: objects, work, .. } = self;
        objects.update(host, &work.plan, facts, scene, &mut work.schedule.versions)
    }

    /// Gives a parameter of a pass another value.
    ///
    /// # Errors
    /// No such pass or parameter, a value that it can't have, or one that needs another plan ([`Plan::parameter`]).
    pub fn set(&mut self, pass: &str, parameter: &str, value: &Value) -> Result<(), Error> {
        let Work { plan, resources, schedule, .. } = &mut self.work;
        let ParamBytes { resource, offset, bytes } = plan.parameter(pass, parameter, value)?;
        let ResourceKind::Uniform(known) = &mut plan.resources[resource].kind else { return Ok(()) };
        let place = &mut known[offset as usize..][..bytes.len()];
        if place == bytes {
            return Ok(());
        }
        place.copy_from_slice(&bytes);
        if let Some(buffer) = resources.buffer(resource) {
            self.host.write(buffer, offset, &bytes);
        }
        schedule.touch(resource);
        Ok(())
    }

    /// Makes what depends on the screen's size anew.
    ///
    /// # Errors
    /// A side is 0 or beyond the device's limit, the plan would be over its budget, or the device has no memory left. The
    /// session then keeps the size that it had.
    pub fn resize(&mut self, width: u32, height: u32) -> Result<(), Error> {
        let limit = self.host.gpu.device.limits().max_texture_dimension_2d;
        if ![width, height].iter().all(|side| (1..=limit).contains(side)) {
            return Err(Error::Screen { width, height, limit });
        }
        let screen = [width, height];
        if screen == self.work.plan.screen {
            return Ok(());
        }
        let was = std::mem::replace(&mut self.work.plan.screen, screen);
        let resized = self.work.remake(&mut self.host, |resource| {
            let of_screen =
                matches!(resource.kind, ResourceKind::Image { extent: ImageExtent::Screen { .. }, .. });
            of_screen || resource.life == Life::History
        });
        if resized.is_err() {
            self.work.plan.screen = was;
        }
        resized
    }

    /// A resource of the plan by name.
    pub(crate) fn object(&self, name: &str) -> Option<(usize, &Object)> {
        let index = self.work.plan.resource(name)?;
        Some((index, self.work.resources.newest(index)))
    }
}
