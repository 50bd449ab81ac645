//! Soft shadow and ambient occlusion.

use glam::Vec3;

use crate::rng::Rng;
use crate::sampling::cosine_hemisphere;
use crate::surface::Surface;
use crate::tracer::Tracer;
use crate::triangle::Ray;

impl Tracer {
    /// One sample of [`crate::Quantity::SoftShadow`].
    pub(crate) fn shadow(&self, surface: &Surface, light: usize, rng: &mut Rng) -> f32 {
        let origin = surface.origin();
        let Some(seen) = self.lamps[light].seen_from(origin) else { return 1.0 };
        if seen.light == Vec3::ZERO {
            return 0.0;
        }
        let sample = seen.sample(rng);
        let above = surface.geometric_normal.dot(sample.direction) > 0.0;
        f32::from(above && self.unblocked(origin, sample.direction, sample.distance))
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
