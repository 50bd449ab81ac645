//! What a picture's pixels show.

use glam::Vec3;
use rayon::prelude::*;
use voxlume_scene::Camera;

use crate::Error;
use crate::request::check_view;
use crate::tracer::Tracer;
use crate::view::View;

/// What the camera sees through a pixel's centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// No surface.
    Nothing,
    /// A surface that emits nothing there.
    Surface,
    /// A surface that emits towards the camera.
    Emitter,
}

impl Tracer {
    /// What each pixel's centre shows, row-major from the top left.
    ///
    /// # Errors
    /// A size or a camera that [`Tracer::render`] would refuse.
    pub fn look(&self, camera: &Camera, width: u32, height: u32) -> Result<Vec<Seen>, Error> {
        check_view(camera, width, height)?;
        let view = View::new(camera, width, height, self.surfaces.geometry.origin);
        let pixels = width as usize * height as usize;
        let look = |index: usize| {
            let (x, y) = (index as u32 % width, index as u32 / width);
            match self.seen(view.ray(x as f32 + 0.5, y as f32 + 0.5)) {
                None => Seen::Nothing,
                Some(surface) if surface.emission == Vec3::ZERO => Seen::Surface,
                Some(_) => Seen::Emitter,
            }
        };
        Ok((0..pixels).into_par_iter().map(look).collect())
    }
}
