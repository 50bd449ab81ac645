//! Whether a scene is the one on the device, but for what may differ from frame to frame.

use voxlume_graph::{Emission, Plan, SceneFacts};
use voxlume_scene::{Instance, LightKind, Scene};

use crate::Error;

/// The scene on the device.
pub(super) struct Known<'a> {
    pub plan: &'a Plan,
    pub facts: &'a SceneFacts,
    pub instances: &'a [Instance],
    /// Vertices of instances that don't move.
    pub still_vertices: usize,
}

impl Known<'_> {
    /// Checks a scene that has passed [`Scene::check_frame`] and makes so many lights.
    pub fn is(&self, scene: &Scene, lights: u32) -> Result<(), Error> {
        let Known { plan, facts, instances, still_vertices } = self;
        let other = |message: String| Err(Error::OtherScene(message));
        let count = |list: &mut dyn Iterator<Item = usize>| list.sum::<usize>() as u32;
        let meshes = || scene.instances.iter().map(|instance| &scene.meshes[instance.mesh]);
        let still = scene.instances.iter().filter(|instance| !instance.moving);
        let still = count(&mut still.map(|instance| scene.meshes[instance.mesh].positions.len()));
        let punctual = |kind: fn(&LightKind) -> bool| {
            scene.lights.iter().filter(|light| kind(&light.kind)).count() as u32
        };
        let point = punctual(|kind| matches!(kind, LightKind::Point { .. }));
        let spot = punctual(|kind| matches!(kind, LightKind::Spot { .. }));
        let polygons = match plan.emission {
            Emission::AreaLights => facts.polygons.unwrap_or(0),
            _ => 0,
        };
        for (what, is, was) in [
            ("lights", lights, facts.punctual() + polygons),
            ("point lights", point, facts.point),
            ("spot lights", spot, facts.spot),
            ("triangles", count(&mut meshes().map(|mesh| mesh.triangles.len())), facts.triangles),
            ("vertices", count(&mut meshes().map(|mesh| mesh.positions.len())), facts.vertices),
            ("vertices that stay", still, *still_vertices as u32),
            ("instances", scene.instances.len() as u32, instances.len() as u32),
        ] {
            if is != was {
                return other(format!("it has {is} {what} instead of {was}"));
            }
        }
        for (instance, known) in scene.instances.iter().zip(*instances) {
            if (instance.mesh, instance.moving) != (known.mesh, known.moving) {
                return other(format!("`{}` is another instance", instance.name));
            }
            if !instance.moving && instance.transform != known.transform {
                return other(format!("`{}` has moved and is not marked as moving", instance.name));
            }
        }
        if scene.sky.max_element() > 0.0 && !facts.sky {
            return other("its sky shines, and was dark".into());
        }
        Ok(())
    }
}
