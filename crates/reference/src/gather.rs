//! Light gathered at a surface by path tracing.

use glam::Vec3;

use crate::lobe::Lobe;
use crate::request::{Gather, Reflection};
use crate::rng::Rng;
use crate::sampling::power_heuristic;
use crate::surface::Surface;
use crate::tracer::Tracer;
use crate::triangle::Ray;

/// Which light sources a surface gathers from directly.
#[derive(Clone, Copy)]
pub(crate) struct Sources {
    pub(crate) lights: bool,
    pub(crate) emission: bool,
    pub(crate) sky: bool,
}

impl Sources {
    pub(crate) const ALL: Sources = Sources { lights: true, emission: true, sky: true };

    pub(crate) fn of(gather: Gather) -> Self {
        Sources { lights: false, emission: gather.emission, sky: gather.sky }
    }
}

impl Tracer {
    /// One sample of the light that `first` scatters through `lobe` towards the eye: from `sources`
    /// directly, and from all sources by way of up to `bounces` other surfaces.
    ///
    /// At each surface lights are sampled one by one and emitters by their power, both joined by the
    /// power heuristic with the direction in which the path goes on; that direction alone finds the sky.
    pub(crate) fn gather(
        &self,
        first: Surface,
        lobe: Lobe,
        mut sources: Sources,
        bounces: u32,
        reflection: Reflection,
        rng: &mut Rng,
    ) -> Vec3 {
        let (mut surface, mut lobe) = (first, lobe);
        let mut sum = Vec3::ZERO;
        let mut throughput = Vec3::ONE;
        for _ in 0..=bounces {
            let origin = surface.origin();
            if sources.lights {
                sum += throughput * self.sample_lights(&surface, origin, &lobe, rng);
            }
            if sources.emission {
                sum += throughput * self.sample_emitter(&surface, origin, &lobe, rng);
            }
            let Some(scattered) = lobe.sample(surface.out, rng) else { break };
            let direction = surface.frame.to_world(scattered.direction);
            throughput *= scattered.weight;
            if surface.geometric_normal.dot(direction) <= 0.0 || throughput == Vec3::ZERO {
                break;
            }
            let ray = Ray { origin, direction, far: f32::INFINITY };
            let met = self.closest(ray);
            if sources.lights {
                let distance = met.map_or(f32::INFINITY, |(_, crossing)| crossing.t as f32);
                sum += throughput * self.met_lights(ray, distance, scattered.pdf);
            }
            let Some((triangle, crossing)) = met else {
                if sources.sky {
                    sum += throughput * self.sky;
                }
                break;
            };
            surface = self.surfaces.surface(ray, triangle, &crossing);
            if sources.emission && surface.emission != Vec3::ZERO {
                let other = self.emitters.pdf(&self.surfaces, triangle, direction, crossing.t as f32);
                sum += throughput * surface.emission * power_heuristic(scattered.pdf, other);
            }
            lobe = surface.lobe(reflection);
            sources = Sources::ALL;
        }
        sum
    }

    fn sample_lights(&self, surface: &Surface, origin: Vec3, lobe: &Lobe, rng: &mut Rng) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for lamp in &self.lamps {
            let Some(seen) = lamp.seen_from(origin) else { continue };
            let sample = seen.sample(rng);
            let (value, pdf) = scatter(surface, lobe, sample.direction);
            let light = value * sample.irradiance * power_heuristic(sample.pdf, pdf);
            if light != Vec3::ZERO && self.unblocked(origin, sample.direction, sample.distance) {
                sum += light;
            }
        }
        sum
    }

    /// Lights that a ray of density `pdf` meets before `distance`.
    fn met_lights(&self, ray: Ray, distance: f32, pdf: f32) -> Vec3 {
        let seen = self.lamps.iter().filter_map(|lamp| lamp.seen_from(ray.origin)?.along(ray.direction));
        seen.filter(|&(.., light)| Self::reaches(distance, light))
            .map(|(radiance, other, _)| radiance * power_heuristic(pdf, other))
            .sum()
    }

    fn sample_emitter(&self, surface: &Surface, origin: Vec3, lobe: &Lobe, rng: &mut Rng) -> Vec3 {
        let Some(sample) = self.emitters.sample(&self.surfaces, origin, rng) else { return Vec3::ZERO };
        let (value, pdf) = scatter(surface, lobe, sample.direction);
        let light = value * sample.radiance / sample.pdf * power_heuristic(sample.pdf, pdf);
        if light != Vec3::ZERO && self.unblocked(origin, sample.point - origin, 1.0) {
            light
        } else {
            Vec3::ZERO
        }
    }
}

/// Scattering function × cosine towards the eye, and the density of the lobe's own samples; zero below
/// the triangle's horizon.
fn scatter(surface: &Surface, lobe: &Lobe, direction: Vec3) -> (Vec3, f32) {
    if surface.geometric_normal.dot(direction) <= 0.0 {
        return (Vec3::ZERO, 0.0);
    }
    lobe.evaluate(surface.out, surface.frame.to_local(direction))
}
