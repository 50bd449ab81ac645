//! Soft shadow and ambient occlusion.

use glam::Vec3;

use crate::render::Sample;
use crate::rng::Rng;
use crate::sampling::cosine_hemisphere;
use crate::surface::Surface;
use crate::tracer::Tracer;
use crate::triangle::Ray;

impl Tracer {
    /// One sample of [`crate::Quantity::SoftShadow`].
    pub(crate) fn shadow(&self, surface: &Surface, light: usize, rng: &mut Rng) -> Sample {
        let origin = surface.origin();
        let Some(seen) = self.lamps[light].seen_from(origin) else {
            return Sample::Share { weight: 1.0, so: true };
        };
        let sample = seen.sample(rng);
        let cosine = surface.frame.normal.dot(sample.direction);
        if seen.light == Vec3::ZERO || cosine <= 0.0 {
            return Sample::Share { weight: 0.0, so: false };
        }
        let above = surface.geometric_normal.dot(sample.direction) > 0.0;
        let so = above && self.unblocked(origin, sample.direction, sample.distance);
        Sample::Share { weight: f64::from(cosine), so }
    }

    /// One sample of [`crate::Quantity::AmbientOcclusion`].
    pub(crate) fn accessibility(&self, surface: &Surface, distance: f32, falloff: f32, rng: &mut Rng) -> f32 {
        let direction: Vec3 = surface.frame.to_world(cosine_hemisphere(rng.square()));
        if surface.geometric_normal.dot(direction) <= 0.0 {
            return 0.0;
        }
        let ray = Ray { origin: surface.origin(), direction, far: distance };
        self.closest(ray).map_or(1.0, |(_, crossing)| 1.0 - 1.0 / (1.0 + falloff * crossing.t as f32))
    }
}
