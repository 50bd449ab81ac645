//! A scene made ready for tracing.

use glam::{DVec3, Vec3};
use voxlume_scene::{Geometry, Scene};

use crate::Error;
use crate::accel::Accel;
use crate::emitter::Emitters;
use crate::light::Lamp;
use crate::surface::{Surface, Surfaces};
use crate::texture::Textures;
use crate::triangle::{Crossing, Ray};

/// Triangles that the hierarchy's 32-bit node indices reach.
pub(crate) const MAX_TRIANGLES: usize = 1 << 30;

/// Shadow rays end this fraction short of their target, so that the target itself doesn't block them.
const NEARLY: f32 = 1.0 - 1.0 / 65_536.0;

/// A scene made ready: triangles in a hierarchy, textures, lights.
///
/// Triangles block light from both sides, with holes where an alpha mask says so. What a single-sided
/// material lacks is its look from behind: the camera sees through it and it emits nothing there.
pub struct Tracer {
    accel: Accel,
    pub(crate) surfaces: Surfaces,
    pub(crate) emitters: Emitters,
    pub(crate) lamps: Vec<Lamp>,
    pub(crate) light_names: Vec<String>,
    pub(crate) sky: Vec3,
}

impl Tracer {
    /// Flattens the scene around its bounds' centre and builds the hierarchy.
    ///
    /// The scene must keep [`Scene`]'s promises (indices in range, numbers finite), as those from its
    /// loaders do. Takes about 150 bytes a triangle and a copy of the textures.
    ///
    /// # Errors
    /// [`Error::Triangles`] for more than 2³⁰ of them.
    pub fn new(scene: &Scene) -> Result<Tracer, Error> {
        let count: usize =
            scene.instances.iter().map(|instance| scene.meshes[instance.mesh].triangles.len()).sum();
        if count > MAX_TRIANGLES {
            return Err(Error::Triangles(count));
        }
        let origin = scene.bounds().map_or(DVec3::ZERO, |(low, high)| (low + high) / 2.0);
        let geometry = Geometry::new(scene, origin);
        let extent = geometry.positions.iter().fold(0.0, |extent: f32, p| extent.max(p.abs().max_element()));
        let surfaces = Surfaces {
            geometry,
            materials: scene.materials.clone(),
            textures: Textures::new(&scene.textures),
            extent,
        };
        let triangles: Vec<_> = (0..count as u32).map(|triangle| surfaces.corners(triangle)).collect();
        Ok(Tracer {
            accel: Accel::new(&triangles, extent),
            emitters: Emitters::new(&surfaces),
            lamps: scene.lights.iter().map(|light| Lamp::new(light, origin)).collect(),
            light_names: scene.lights.iter().map(|light| light.name.clone()).collect(),
            sky: scene.sky,
            surfaces,
        })
    }

    /// The surface that the camera sees along `ray`.
    pub(crate) fn seen(&self, ray: Ray) -> Option<Surface> {
        let accept = |triangle, crossing: &Crossing| {
            let visible = crossing.front || self.surfaces.material(triangle).double_sided;
            visible && self.surfaces.solid(triangle, crossing.weights)
        };
        let (triangle, crossing) = self.accel.closest(ray, accept)?;
        Some(self.surfaces.surface(ray, triangle, &crossing))
    }

    /// The triangle that `ray` meets first.
    pub(crate) fn closest(&self, ray: Ray) -> Option<(u32, Crossing)> {
        self.accel.closest(ray, |triangle, crossing| self.surfaces.solid(triangle, crossing.weights))
    }

    /// Whether light passes from `origin` along `direction` for `distance`, in units of `direction`.
    pub(crate) fn unblocked(&self, origin: Vec3, direction: Vec3, distance: f32) -> bool {
        let ray = Ray { origin, direction, far: distance * NEARLY };
        !self.accel.any(ray, |triangle, crossing| self.surfaces.solid(triangle, crossing.weights))
    }

    /// Whether a triangle met at `met` leaves a light at `distance` along the same ray visible.
    pub(crate) fn reaches(met: f32, distance: f32) -> bool {
        met >= distance * NEARLY
    }
}
