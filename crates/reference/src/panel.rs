//! Visibility of an evenly emitting quadrilateral.

use glam::Vec3;

use crate::render::Sample;
use crate::request::Panel;
use crate::rng::Rng;
use crate::surface::Surface;
use crate::tracer::Tracer;

impl Tracer {
    /// One sample of [`crate::Quantity::PanelShadow`]: a point uniform over the panel, weighted by what it gives the
    /// surface if nothing is in between. Density and radiance are constant and cancel in the ratio.
    pub(crate) fn panel_shadow(&self, surface: &Surface, panel: &Panel, rng: &mut Rng) -> Sample {
        let [a, b, c, d] = panel.corners.map(|corner| (corner - self.surfaces.geometry.origin).as_vec3());
        let triangles = [[a, b, c], [a, c, d]];
        let normals = triangles.map(|[p, q, r]| (q - p).cross(r - p));
        let [first, second] = normals.map(Vec3::length);
        let which = usize::from(rng.uniform() * (first + second) >= first);
        let ([p, q, r], [u, v]) = (triangles[which], rng.square());
        let root = u.sqrt();
        let point = p * (1.0 - root) + q * (root * (1.0 - v)) + r * (root * v);
        let origin = surface.origin();
        let to = point - origin;
        let direction = to.normalize_or_zero();
        let facing = -normals[which].normalize_or_zero().dot(direction);
        let facing = if panel.double_sided { facing.abs() } else { facing };
        let cosine = surface.frame.normal.dot(direction);
        let weight = facing.max(0.0) * cosine.max(0.0) / to.length_squared();
        if !(weight > 0.0 && weight.is_finite()) {
            return Sample::Share { weight: 0.0, so: false };
        }
        let above = surface.geometric_normal.dot(direction) > 0.0;
        Sample::Share { weight: f64::from(weight), so: above && self.unblocked(origin, to, 1.0) }
    }
}
