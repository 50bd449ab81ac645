//! From samples to a picture.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use glam::Vec3;
use rayon::prelude::*;

use crate::Error;
use crate::gather::Sources;
use crate::lobe::Lobe;
use crate::picture::{Picture, Ratio, Statistics};
use crate::request::{PixelSampling, Quantity, Request};
use crate::rng::Rng;
use crate::surface::Surface;
use crate::tracer::Tracer;
use crate::view::View;

/// One sample of a quantity.
pub(crate) enum Sample {
    /// The quantity is the mean of these.
    Value(Vec3),
    /// The quantity is the weight of those that are so over the weight of all.
    Share { weight: f64, so: bool },
}

impl Tracer {
    /// Computes a picture on the current rayon pool's threads. The same request gives the same bits,
    /// whatever their number.
    ///
    /// `progress` is told the finished fraction, rising to 1, from whichever thread finishes a row.
    /// Raising `cancel` ends the work within a pixel's time.
    ///
    /// # Errors
    /// [`Error::Cancelled`]; every fault of the request; [`Error::NotFinite`] where radiance overflows.
    pub fn render(
        &self,
        request: &Request,
        progress: &(dyn Fn(f32) + Sync),
        cancel: &AtomicBool,
    ) -> Result<Picture, Error> {
        request.check()?;
        if let Quantity::SoftShadow { light: index } = request.quantity
            && index >= self.lamps.len()
        {
            return Err(Error::Light { index, lights: self.light_names.clone() });
        }
        let (width, height) = (request.width as usize, request.height as usize);
        let view = View::new(&request.camera, request.width, request.height, self.surfaces.geometry.origin);
        let mut mean = vec![[0.0; 3]; width * height];
        let mut standard_error = vec![[0.0; 3]; width * height];
        let finished = Mutex::new(0);
        let rows = mean.par_chunks_mut(width).zip(standard_error.par_chunks_mut(width)).enumerate();
        rows.try_for_each(|(y, (mean, error))| {
            for x in 0..width {
                if cancel.load(Ordering::Relaxed) {
                    return Err(Error::Cancelled);
                }
                let (x32, y32) = (x as u32, y as u32);
                (mean[x], error[x]) = self.pixel(request, &view, x32, y32);
                if !mean[x].iter().chain(&error[x]).all(|value| value.is_finite()) {
                    return Err(Error::NotFinite { x: x32, y: y32 });
                }
            }
            let mut finished = finished.lock().unwrap_or_else(PoisonError::into_inner);
            *finished += 1;
            progress(*finished as f32 / height as f32);
            Ok(())
        })?;
        Ok(Picture { width: request.width, height: request.height, mean, standard_error })
    }

    /// A pixel's mean and its standard error.
    fn pixel(&self, request: &Request, view: &View, x: u32, y: u32) -> ([f32; 3], [f32; 3]) {
        let (x, y) = (x as f32, y as f32);
        let index = u64::from(y as u32) * u64::from(request.width) + u64::from(x as u32);
        let centre = match request.sampling {
            PixelSampling::Centre => Some(self.seen(view.ray(x + 0.5, y + 0.5))),
            PixelSampling::Area => None,
        };
        let (mut statistics, mut ratio) = (Statistics::default(), Ratio::default());
        for sample in 0..request.samples {
            let mut rng = Rng::new(request.seed, index, u64::from(sample));
            let seen = centre.unwrap_or_else(|| {
                let [dx, dy] = rng.square();
                self.seen(view.ray(x + dx, y + dy))
            });
            match self.sample(request, seen, &mut rng) {
                Sample::Value(value) => statistics.add(value.to_array()),
                Sample::Share { weight, so } => ratio.add(weight, so),
            }
        }
        ratio.finish().unwrap_or_else(|| statistics.finish())
    }

    /// One sample of the request's quantity.
    fn sample(&self, request: &Request, seen: Option<Surface>, rng: &mut Rng) -> Sample {
        let Some(surface) = seen else { return Sample::Value(self.background(request.quantity)) };
        let reflection = request.reflection;
        Sample::Value(match request.quantity {
            Quantity::PanelShadow(panel) => return self.panel_shadow(&surface, &panel, rng),
            Quantity::SoftShadow { light } => return self.shadow(&surface, light, rng),
            Quantity::AmbientOcclusion { distance, falloff } => {
                Vec3::splat(self.accessibility(&surface, distance, falloff, rng))
            }
            // Irradiance is π times the radiance that a white Lambertian surface reflects.
            Quantity::Diffuse(gather) => {
                let lobe = Lobe::Lambert(Vec3::splat(std::f32::consts::PI));
                self.gather(surface, lobe, Sources::of(gather), gather.bounces, reflection, rng)
            }
            Quantity::Specular(gather) => {
                let lobe = surface.mirror_lobe(rng);
                self.gather(surface, lobe, Sources::of(gather), gather.bounces, reflection, rng)
            }
            Quantity::Final { bounces } => {
                let lobe = surface.lobe(reflection);
                surface.emission + self.gather(surface, lobe, Sources::ALL, bounces, reflection, rng)
            }
        })
    }

    /// Where the camera sees no surface.
    fn background(&self, quantity: Quantity) -> Vec3 {
        match quantity {
            Quantity::SoftShadow { .. } | Quantity::PanelShadow(_) | Quantity::AmbientOcclusion { .. } => {
                Vec3::ONE
            }
            Quantity::Diffuse(_) | Quantity::Specular(_) => Vec3::ZERO,
            Quantity::Final { .. } => self.sky,
        }
    }
}
