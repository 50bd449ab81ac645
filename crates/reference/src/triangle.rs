//! Ray against triangle, watertight.

use glam::{DVec3, Vec3};

/// A ray; `direction` need not be of unit length, distances are in its units.
#[derive(Clone, Copy)]
pub(crate) struct Ray {
    pub(crate) origin: Vec3,
    pub(crate) direction: Vec3,
    /// Only hits nearer than this count.
    pub(crate) far: f32,
}

/// Where a ray meets a triangle's plane within its edges.
#[derive(Clone, Copy)]
pub(crate) struct Crossing {
    /// Distance in units of the ray's direction, above 0.
    pub(crate) t: f64,
    /// Barycentric weights of the three corners.
    pub(crate) weights: [f32; 3],
    /// Whether the ray comes from the side where the corners run counter-clockwise.
    pub(crate) front: bool,
}

/// A ray turned so that it runs along +z: the axes' permutation and the shear of
/// Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection".
pub(crate) struct Sheared {
    ray: Ray,
    axes: [usize; 3],
    shear: [f32; 2],
}

impl Sheared {
    pub(crate) fn new(ray: Ray) -> Self {
        let d = ray.direction;
        let z = d.abs().max_position();
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        Sheared { ray, axes: [x, y, z], shear: [d[x] / d[z], d[y] / d[z]] }
    }

    /// The crossing with a triangle, or none. Neighbouring triangles leave no gap between them.
    ///
    /// Edges are judged in f32 (in f64 where a result is 0), the distance in f64: so a ray that
    /// starts above a plane by no more than rounding never meets that plane.
    #[inline(always)]
    pub(crate) fn cross(&self, corners: &[Vec3; 3]) -> Option<Crossing> {
        let [x, y, z] = self.axes;
        let project = |corner: Vec3| {
            let v = corner - self.ray.origin;
            [v[x] - self.shear[0] * v[z], v[y] - self.shear[1] * v[z]]
        };
        let [a, b, c] = corners.map(project);
        let mut u = c[0] * b[1] - c[1] * b[0];
        let mut v = a[0] * c[1] - a[1] * c[0];
        let mut w = b[0] * a[1] - b[1] * a[0];
        if u == 0.0 || v == 0.0 || w == 0.0 {
            let edge = |p: [f32; 2], q: [f32; 2]| {
                (f64::from(p[0]) * f64::from(q[1]) - f64::from(p[1]) * f64::from(q[0])) as f32
            };
            (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
        }
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let sum = u + v + w;
        if sum == 0.0 {
            return None;
        }
        let [p, q, r] = corners.map(|corner| corner.as_dvec3());
        let normal: DVec3 = (q - p).cross(r - p);
        let slope = normal.dot(self.ray.direction.as_dvec3());
        let t = normal.dot(p - self.ray.origin.as_dvec3()) / slope;
        // A slope of 0 gives an infinity or no number.
        (t > 0.0 && t.is_finite()).then(|| Crossing {
            t,
            weights: [u / sum, v / sum, w / sum],
            front: slope < 0.0,
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn cross(origin: Vec3, direction: Vec3, corners: [Vec3; 3]) -> Option<Crossing> {
        Sheared::new(Ray { origin, direction, far: f32::INFINITY }).cross(&corners)
    }

    #[test]
    fn distance_weights_and_side() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let hit = cross(Vec3::new(0.25, 0.5, 2.0), Vec3::NEG_Z, corners).unwrap();
        assert_eq!((hit.t, hit.weights, hit.front), (2.0, [0.25, 0.25, 0.5], true));
        let hit = cross(Vec3::new(0.25, 0.5, -2.0), Vec3::Z * 4.0, corners).unwrap();
        assert_eq!((hit.t, hit.weights, hit.front), (0.5, [0.25, 0.25, 0.5], false));
        assert!(cross(Vec3::new(0.25, 0.5, 2.0), Vec3::Z, corners).is_none());
        assert!(cross(Vec3::new(0.7, 0.7, 2.0), Vec3::NEG_Z, corners).is_none());
        assert!(cross(Vec3::new(0.2, 0.2, 2.0), Vec3::NEG_Z, [Vec3::ZERO, Vec3::X, Vec3::X]).is_none());
        // In the triangle's own plane.
        assert!(cross(Vec3::new(-1.0, 0.1, 0.0), Vec3::X, corners).is_none());
    }

    #[test]
    fn no_ray_slips_between_the_triangles_of_a_fan() {
        let mut rng = Rng::new(5, 0, 0);
        let apex = Vec3::new(0.1, 0.2, 0.3);
        let rim: Vec<Vec3> = (0..7)
            .map(|i| {
                let (sin, cos) = (i as f32 / 7.0 * std::f32::consts::TAU).sin_cos();
                Vec3::new(2.0 * cos, 2.0 * sin, 0.1 * i as f32)
            })
            .collect();
        for i in 0..20_000 {
            // Aim exactly at points of shared edges.
            let target = apex.lerp(rim[i % 7], rng.uniform() * 0.9);
            let origin = Vec3::new(rng.uniform() - 0.5, rng.uniform() - 0.5, 3.0 + rng.uniform());
            let hits = (0..7)
                .filter(|&k| cross(origin, target - origin, [apex, rim[k], rim[(k + 1) % 7]]).is_some())
                .count();
            assert!(hits >= 1, "ray {i}");
        }
    }
}
