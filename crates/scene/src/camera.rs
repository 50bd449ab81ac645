//! Cameras aimed.

use glam::{DVec3, Vec3};
use voxlume_fault::{Fault, suggest};

use crate::{Camera, Scene};

impl Camera {
    /// A camera at `eye` that sees `target` in the middle of its picture, `up` upwards.
    ///
    /// `vertical_fov` is in radians, in (0, π). `None` if there is no such view: `eye` is at `target`, `up`
    /// is along the line between them, or a number is not finite.
    pub fn look_at(
        name: impl Into<String>,
        eye: DVec3,
        target: DVec3,
        up: DVec3,
        vertical_fov: f32,
    ) -> Option<Camera> {
        let forward = (target - eye).try_normalize()?;
        let up = up.try_normalize()?.reject_from_normalized(forward);
        // Rounding leaves a direction of sorts even where there is none.
        let up: Vec3 = up.try_normalize().filter(|_| up.length() > 1e-6)?.as_vec3();
        Some(Camera { name: name.into(), eye, forward: forward.as_vec3(), up, vertical_fov })
    }
}

impl Scene {
    /// The camera of that name, or the first one.
    ///
    /// # Errors
    /// There is no such camera.
    pub fn camera(&self, name: Option<&str>) -> Result<&Camera, Fault> {
        let found = match name {
            Some(name) => self.cameras.iter().find(|camera| camera.name == name),
            None => self.cameras.first(),
        };
        let unknown = || {
            let names = self.cameras.iter().map(|camera| camera.name.as_str());
            Fault::new(format!("unknown camera `{}`", name.unwrap_or_default()))
                .note(suggest(name.unwrap_or_default(), names))
        };
        found.ok_or_else(unknown)
    }
}
