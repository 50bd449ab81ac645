//! The surface that a ray meets.

use glam::{DVec3, Vec2, Vec3, Vec4};
use voxlume_scene::{DIELECTRIC_F0, Geometry, Material};

use crate::lobe::Lobe;
use crate::request::Reflection;
use crate::rng::Rng;
use crate::sampling::Frame;
use crate::texture::Textures;
use crate::triangle::{Crossing, Ray};

/// GGX α below this is taken as this: a mirror to a hundredth of a degree, yet still a finite density.
const MIN_ALPHA: f32 = 1e-4;

/// Triangles with their materials.
pub(crate) struct Surfaces {
    pub(crate) geometry: Geometry,
    pub(crate) materials: Vec<Material>,
    pub(crate) textures: Textures,
    /// Largest absolute coordinate.
    pub(crate) extent: f32,
}

/// A point of a surface, both normals turned to the side that the ray came from.
#[derive(Clone, Copy)]
pub(crate) struct Surface {
    position: DVec3,
    pub(crate) geometric_normal: Vec3,
    pub(crate) frame: Frame,
    /// Back along the ray, unit, in the local frame.
    pub(crate) out: Vec3,
    /// Radiance emitted along `out`.
    pub(crate) emission: Vec3,
    base_color: Vec3,
    metallic: f32,
    alpha: f32,
    extent: f32,
}

impl Surface {
    /// How the surface reflects.
    pub(crate) fn lobe(&self, reflection: Reflection) -> Lobe {
        let diffuse = self.base_color * (1.0 - self.metallic);
        match reflection {
            Reflection::Gltf => {
                let f0 = Vec3::splat(DIELECTRIC_F0).lerp(self.base_color, self.metallic);
                Lobe::Gltf { diffuse, f0, alpha: self.alpha }
            }
            Reflection::Lambert => Lobe::Lambert(diffuse),
        }
    }

    /// The lobe that the specular quantity gathers through.
    pub(crate) fn mirror_lobe(&self, rng: &mut Rng) -> Lobe {
        Lobe::mirror_directions(self.out, self.alpha, rng)
    }

    /// Where rays leave from: above the surface by more than positions are rounded by, so that they
    /// meet neither this triangle nor another in the same plane.
    pub(crate) fn origin(&self) -> Vec3 {
        let offset =
            self.position.abs().max_element() * 2f64.powi(-20) + f64::from(self.extent) * 2f64.powi(-24);
        (self.position + self.geometric_normal.as_dvec3() * offset).as_vec3()
    }
}

impl Surfaces {
    /// A triangle's corners.
    pub(crate) fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.geometry.triangles[triangle as usize].map(|vertex| self.geometry.positions[vertex as usize])
    }

    pub(crate) fn material(&self, triangle: u32) -> &Material {
        let [vertex, ..] = self.geometry.triangles[triangle as usize];
        &self.materials[self.geometry.materials[vertex as usize] as usize]
    }

    /// Whether the alpha mask leaves the triangle solid there.
    pub(crate) fn solid(&self, triangle: u32, weights: [f32; 3]) -> bool {
        let material = self.material(triangle);
        let Some(cutoff) = material.alpha_cutoff else { return true };
        let texel = material
            .base_color_texture
            .map_or(1.0, |texture| self.textures.sample(texture.texture, self.uv(triangle, weights)).w);
        material.base_color.w * texel >= cutoff
    }

    /// Radiance emitted to the front, or to the back of a two-sided material; zero in holes.
    pub(crate) fn emission(&self, triangle: u32, weights: [f32; 3], front: bool) -> Vec3 {
        let material = self.material(triangle);
        let lit = front || material.double_sided;
        if !lit || material.emission == Vec3::ZERO || !self.solid(triangle, weights) {
            return Vec3::ZERO;
        }
        let texel = material
            .emission_texture
            .map_or(Vec4::ONE, |texture| self.textures.sample(texture.texture, self.uv(triangle, weights)));
        material.emission * texel.truncate()
    }

    /// The surface where `ray` meets `triangle`.
    pub(crate) fn surface(&self, ray: Ray, triangle: u32, crossing: &Crossing) -> Surface {
        let [p, q, r] = self.corners(triangle).map(|corner| corner.as_dvec3());
        let turn = if crossing.front { 1.0 } else { -1.0 };
        let geometric_normal = ((q - p).cross(r - p).normalize_or(DVec3::Y)).as_vec3() * turn;
        let material = self.material(triangle);
        let uv = self.uv(triangle, crossing.weights);
        let sample = |texture: Option<voxlume_scene::TextureRef>| {
            texture.map_or(Vec4::ONE, |texture| self.textures.sample(texture.texture, uv))
        };
        let normal = self.shading_normal(triangle, crossing.weights, uv) * turn;
        let normal = if normal.dot(geometric_normal) < 0.0 { -normal } else { normal };
        let frame = Frame::new(normal.normalize_or(geometric_normal));
        let surface = sample(material.metallic_roughness_texture);
        let roughness = material.roughness * surface.y;
        Surface {
            position: ray.origin.as_dvec3() + crossing.t * ray.direction.as_dvec3(),
            geometric_normal,
            frame,
            out: frame.to_local(-ray.direction.normalize()),
            emission: self.emission(triangle, crossing.weights, crossing.front),
            base_color: (material.base_color * sample(material.base_color_texture)).truncate(),
            metallic: material.metallic * surface.z,
            alpha: (roughness * roughness).max(MIN_ALPHA),
            extent: self.extent,
        }
    }

    /// The interpolated normal, bent by the normal map; not of unit length.
    fn shading_normal(&self, triangle: u32, weights: [f32; 3], uv: Vec2) -> Vec3 {
        let vertices = self.geometry.triangles[triangle as usize];
        let interpolated: Vec3 =
            vertices.iter().zip(weights).map(|(&vertex, w)| self.geometry.normals[vertex as usize] * w).sum();
        let material = self.material(triangle);
        let Some(map) = material.normal_texture else { return interpolated };
        let normal = interpolated.normalize_or_zero();
        let tangent: Vec4 = vertices
            .iter()
            .zip(weights)
            .map(|(&vertex, w)| self.geometry.tangents[vertex as usize] * w)
            .sum();
        let along = tangent.truncate();
        let Some(along) = (along - normal * normal.dot(along)).try_normalize() else { return normal };
        let bitangent = normal.cross(along) * tangent.w.signum();
        let texel = self.textures.sample(map.texture, uv).truncate() * 2.0 - 1.0;
        let scale = material.normal_scale;
        along * (texel.x * scale) + bitangent * (texel.y * scale) + normal * texel.z
    }

    fn uv(&self, triangle: u32, weights: [f32; 3]) -> Vec2 {
        let vertices = self.geometry.triangles[triangle as usize];
        vertices.iter().zip(weights).map(|(&vertex, w)| self.geometry.uvs[vertex as usize] * w).sum()
    }
}
