//! Which triangle a ray meets first.

use glam::{Vec3, Vec3A};
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, leaf_collapser::collapse, reinsertion::ReinsertionOptimizer};
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use obvhs::ray::RayHit;

use crate::rng::Rng;
use crate::triangle::{Crossing, Ray, Sheared};

/// A bounding volume hierarchy over triangles.
pub(crate) struct Accel {
    bvh: Bvh2,
    /// In the order of the hierarchy's leaves, so that a leaf's triangles are neighbours in memory.
    leaves: Vec<Leaf>,
}

struct Leaf {
    corners: [Vec3; 3],
    triangle: u32,
}

/// Boxes grow by this much of the largest coordinate: more than the rounding of a slab test over the
/// scene's diameter, so that no ray misses the box of a triangle it meets.
const PADDING: f32 = 1e-6;

impl Accel {
    /// `extent` is the largest absolute coordinate.
    pub(crate) fn new(triangles: &[[Vec3; 3]], extent: f32) -> Self {
        let mut rng = Rng::new(0, 0, 0);
        let boxes: Vec<Aabb> = triangles.iter().map(|corners| padded(corners, extent, &mut rng)).collect();
        let mut bvh = PlocBuilder::with_capacity(boxes.len()).build(
            PlocSearchDistance::Medium,
            &boxes,
            (0..boxes.len() as u32).collect(),
            SortPrecision::U64,
            3,
        );
        ReinsertionOptimizer::default().run(&mut bvh, 0.05, None);
        collapse(&mut bvh, 8, 3.0);
        if !bvh.nodes.is_empty() {
            bvh.max_depth = bvh.depth(0) + 1;
        }
        let leaves = bvh
            .primitive_indices
            .iter()
            .map(|&triangle| Leaf { corners: triangles[triangle as usize], triangle })
            .collect();
        Accel { bvh, leaves }
    }

    /// The nearest triangle and crossing that `accept` takes.
    pub(crate) fn closest(
        &self,
        ray: Ray,
        accept: impl Fn(u32, &Crossing) -> bool,
    ) -> Option<(u32, Crossing)> {
        let sheared = Sheared::new(ray);
        let mut best = None;
        self.bvh.ray_traverse(bvh_ray(ray), &mut RayHit::none(), |limit, leaf| {
            let leaf = &self.leaves[leaf];
            let Some(crossing) = sheared.cross(&leaf.corners) else { return f32::INFINITY };
            let t = crossing.t as f32;
            if t >= limit.tmax || !accept(leaf.triangle, &crossing) {
                return f32::INFINITY;
            }
            best = Some((leaf.triangle, crossing));
            t
        });
        best
    }

    /// Whether any triangle that `accept` takes lies before `ray.far`.
    pub(crate) fn any(&self, ray: Ray, accept: impl Fn(u32, &Crossing) -> bool) -> bool {
        let sheared = Sheared::new(ray);
        !self.bvh.ray_traverse_miss(bvh_ray(ray), |_, leaf| {
            let leaf = &self.leaves[leaf];
            match sheared.cross(&leaf.corners) {
                Some(crossing) if accept(leaf.triangle, &crossing) => crossing.t as f32,
                _ => f32::INFINITY,
            }
        })
    }
}

fn bvh_ray(ray: Ray) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), 0.0, ray.far)
}

/// Sides grow by random amounts between once and twice the padding: the builder takes quadratic time
/// over boxes that are exactly equal, as duplicated triangles have.
fn padded(corners: &[Vec3; 3], extent: f32, rng: &mut Rng) -> Aabb {
    let aabb = Aabb::from_points(&corners.map(Vec3A::from));
    let mut side = || (1.0 + Vec3A::new(rng.uniform(), rng.uniform(), rng.uniform())) * (PADDING * extent);
    Aabb::new(aabb.min - side(), aabb.max + side())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn down(x: f32, y: f32) -> Ray {
        Ray { origin: Vec3::new(x, y, 3.0), direction: Vec3::NEG_Z, far: f32::INFINITY }
    }

    fn anything(_: u32, _: &Crossing) -> bool {
        true
    }

    #[test]
    fn an_empty_scene_is_missed() {
        let accel = Accel::new(&[], 1.0);
        assert!(accel.closest(down(0.0, 0.0), anything).is_none());
        assert!(!accel.any(down(0.0, 0.0), anything));
    }

    #[test]
    fn the_nearest_accepted_triangle_is_found() {
        let layer = |z: f32| [Vec3::new(-1.0, -1.0, z), Vec3::new(3.0, -1.0, z), Vec3::new(-1.0, 3.0, z)];
        let accel = Accel::new(&[layer(0.0), layer(2.0), layer(1.0)], 3.0);
        let (triangle, crossing) = accel.closest(down(0.0, 0.0), anything).unwrap();
        assert_eq!((triangle, crossing.t), (1, 1.0));
        let (triangle, crossing) = accel.closest(down(0.0, 0.0), |i, _| i != 1).unwrap();
        assert_eq!((triangle, crossing.t), (2, 2.0));
        assert!(!accel.any(Ray { far: 1.0, ..down(0.0, 0.0) }, anything));
        assert!(accel.any(Ray { far: 1.01, ..down(0.0, 0.0) }, anything));
        assert!(!accel.any(down(0.0, 0.0), |_, _| false));
    }

    /// Equal boxes cost the builder quadratic time without the random padding: minutes for these.
    #[test]
    fn many_equal_triangles_are_built_quickly_and_hit() {
        let one = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let accel = Accel::new(&vec![one; 50_000], 1.0);
        assert!(accel.any(down(0.2, 0.2), anything));
        assert!(!accel.any(down(0.7, 0.7), anything));
    }
}
