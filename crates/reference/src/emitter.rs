//! Emissive triangles as light sources.

use glam::Vec3;

use crate::rng::Rng;
use crate::sampling::luminance;
use crate::surface::Surfaces;

/// Triangles that emit, to be chosen in proportion to their power.
pub(crate) struct Emitters {
    triangles: Vec<u32>,
    /// Cumulative chance after each of `triangles`, ending at 1.
    cumulative: Vec<f64>,
    /// Chance of each triangle of the scene per area of it, 0 for those that don't emit.
    density: Vec<f32>,
}

/// A point on an emitter, seen from a shaded point.
pub(crate) struct EmitterSample {
    pub(crate) point: Vec3,
    /// Towards the point, unit.
    pub(crate) direction: Vec3,
    pub(crate) radiance: Vec3,
    /// Per solid angle.
    pub(crate) pdf: f32,
}

/// Points per edge of the grid over a triangle that its textured emission is averaged over.
const GRID: u8 = 4;
/// Share of its untextured power that a textured emitter is at least chosen by, so that a bright
/// texel between the averaged points is still found.
const FLOOR: f64 = 0.05;

impl Emitters {
    pub(crate) fn new(surfaces: &Surfaces) -> Self {
        let count = surfaces.geometry.triangles.len();
        let powers: Vec<(u32, f64, f64)> = (0..count as u32)
            .map(|triangle| (triangle, area(surfaces.corners(triangle))))
            .map(|(triangle, area)| (triangle, area, area * brightness(surfaces, triangle)))
            .filter(|&(.., power)| power > 0.0)
            .collect();
        let total: f64 = powers.iter().map(|(.., power)| power).sum();
        let mut emitters =
            Emitters { triangles: Vec::new(), cumulative: Vec::new(), density: vec![0.0; count] };
        let mut sum = 0.0;
        for (triangle, area, power) in powers {
            sum += power;
            emitters.triangles.push(triangle);
            emitters.cumulative.push(sum / total);
            emitters.density[triangle as usize] = (power / total / area) as f32;
        }
        emitters
    }

    /// A point of an emitter as seen from `from`, or none where no light comes from there.
    pub(crate) fn sample(&self, surfaces: &Surfaces, from: Vec3, rng: &mut Rng) -> Option<EmitterSample> {
        let last = self.triangles.len().checked_sub(1)?;
        let choice = f64::from(rng.word()) * 2f64.powi(-32);
        let index = self.cumulative.partition_point(|&c| c <= choice).min(last);
        let triangle = self.triangles[index];
        let weights = uniform_weights(rng.square());
        let corners = surfaces.corners(triangle);
        let point: Vec3 = corners.iter().zip(weights).map(|(&corner, w)| corner * w).sum();
        let to = point - from;
        let direction = to.try_normalize()?;
        let front = normal(corners).dot(direction) < 0.0;
        let radiance = surfaces.emission(triangle, weights, front);
        let pdf = self.pdf(surfaces, triangle, direction, to.length());
        (radiance != Vec3::ZERO && pdf.is_normal()).then_some(EmitterSample {
            point,
            direction,
            radiance,
            pdf,
        })
    }

    /// Density per solid angle with which [`Emitters::sample`] takes the point of `triangle` that lies
    /// `distance` away along the unit vector `direction`.
    pub(crate) fn pdf(&self, surfaces: &Surfaces, triangle: u32, direction: Vec3, distance: f32) -> f32 {
        let density = self.density[triangle as usize];
        if density == 0.0 {
            return 0.0;
        }
        density * distance * distance / normal(surfaces.corners(triangle)).dot(direction).abs()
    }
}

/// Mean luminance of the triangle's emission, both sides taken together.
fn brightness(surfaces: &Surfaces, triangle: u32) -> f64 {
    let material = surfaces.material(triangle);
    let plain = f64::from(luminance(material.emission));
    if plain == 0.0 || (material.emission_texture.is_none() && material.alpha_cutoff.is_none()) {
        return plain;
    }
    let at = |index: u8| (f32::from(index) + 0.5) / f32::from(GRID);
    let points = (0..GRID).flat_map(|i| (0..GRID).map(move |j| uniform_weights([at(i), at(j)])));
    let sum: f64 =
        points.map(|weights| f64::from(luminance(surfaces.emission(triangle, weights, true)))).sum();
    (sum / f64::from(GRID * GRID)).max(FLOOR * plain)
}

/// Barycentric weights, uniform over the area.
fn uniform_weights([u, v]: [f32; 2]) -> [f32; 3] {
    let root = u.sqrt();
    [1.0 - root, root * (1.0 - v), root * v]
}

fn area([p, q, r]: [Vec3; 3]) -> f64 {
    let [p, q, r] = [p, q, r].map(Vec3::as_dvec3);
    (q - p).cross(r - p).length() / 2.0
}

fn normal([p, q, r]: [Vec3; 3]) -> Vec3 {
    let [p, q, r] = [p, q, r].map(Vec3::as_dvec3);
    (q - p).cross(r - p).normalize_or_zero().as_vec3()
}
