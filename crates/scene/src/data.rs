//! The scene as data.

use glam::{DAffine3, DVec3, Vec2, Vec3, Vec4};

use crate::Animation;

/// A scene: what is lit, what lights it, and where it is seen from. Every index in it is in range
/// and every number finite; the loaders refuse anything else, and [`Scene::check`] does of scenes made in memory.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// The file's stem, for titles and reports.
    pub name: String,
    /// Materials; a mesh names one by index.
    pub materials: Vec<Material>,
    /// Images that materials sample.
    pub textures: Vec<Texture>,
    /// Triangle meshes in their own space.
    pub meshes: Vec<Mesh>,
    /// Meshes placed in the world.
    pub instances: Vec<Instance>,
    /// Directional, point and spot lights.
    pub lights: Vec<Light>,
    /// Radiance that arrives from everywhere outside the scene, W·m⁻²·sr⁻¹.
    pub sky: Vec3,
    /// Cameras, the first being the default. Never empty: a loader adds one that frames the scene.
    pub cameras: Vec<Camera>,
    /// What follows a path; its instances are marked as moving.
    pub animation: Animation,
}

/// What a dielectric reflects at normal incidence (glTF 2.0, appendix B); a metal reflects its base colour.
pub const DIELECTRIC_F0: f32 = 0.04;

/// A glTF metallic-roughness material. Textures multiply their factors.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name in the file, or `material N`.
    pub name: String,
    /// Linear RGB reflectance and alpha, each in `[0, 1]`.
    pub base_color: Vec4,
    /// sRGB texture of the base colour.
    pub base_color_texture: Option<TextureRef>,
    /// 0 dielectric, 1 metal.
    pub metallic: f32,
    /// Perceptual roughness in `[0, 1]`; GGX α is its square.
    pub roughness: f32,
    /// Linear texture, roughness in G and metallic in B.
    pub metallic_roughness_texture: Option<TextureRef>,
    /// Linear tangent-space normal map.
    pub normal_texture: Option<TextureRef>,
    /// Scale of the normal map's x and y.
    pub normal_scale: f32,
    /// Emitted radiance, W·m⁻²·sr⁻¹ (emissive factor × emissive strength).
    pub emission: Vec3,
    /// sRGB texture of the emission.
    pub emission_texture: Option<TextureRef>,
    /// Texels of alpha below this are holes; `None` for opaque.
    pub alpha_cutoff: Option<f32>,
    /// Whether the back side is shaded too; else the camera looks through it.
    pub double_sided: bool,
}

impl Material {
    /// Whether texels of low alpha are holes.
    pub fn is_masked(&self) -> bool {
        self.alpha_cutoff.is_some_and(|cutoff| cutoff > 0.0)
    }
}

impl Default for Material {
    fn default() -> Self {
        Material {
            name: String::new(),
            base_color: Vec4::ONE,
            base_color_texture: None,
            metallic: 0.0,
            roughness: 1.0,
            metallic_roughness_texture: None,
            normal_texture: None,
            normal_scale: 1.0,
            emission: Vec3::ZERO,
            emission_texture: None,
            alpha_cutoff: None,
            double_sided: false,
        }
    }
}

/// A texture as a material uses it: `uv' = offset + rotate(uv * scale)` is already applied to the mesh's
/// coordinates when no two textures of a material disagree, which the loader checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureRef {
    /// Index in [`Scene::textures`].
    pub texture: usize,
}

/// An RGBA8 image, row-major, first row at v = 0. Repeats outside `[0, 1]`.
#[derive(Clone, PartialEq)]
pub struct Texture {
    /// The name in the file, or `texture N`.
    pub name: String,
    /// Width in texels, at least 1.
    pub width: u32,
    /// Height in texels, at least 1.
    pub height: u32,
    /// `width * height * 4` bytes.
    pub rgba: Vec<u8>,
    /// Whether RGB are sRGB-encoded (colour) or linear (data).
    pub srgb: bool,
}

impl std::fmt::Debug for Texture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Texture({} {}x{} srgb={})", self.name, self.width, self.height, self.srgb)
    }
}

/// Triangles of one material. All attribute arrays have the same length.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Name for messages.
    pub name: String,
    /// Positions, finite.
    pub positions: Vec<Vec3>,
    /// Unit normals.
    pub normals: Vec<Vec3>,
    /// Unit tangents with the bitangent's sign in w; arbitrary but valid where there is no normal map.
    pub tangents: Vec<Vec4>,
    /// Texture coordinates, finite.
    pub uvs: Vec<Vec2>,
    /// Counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Index in [`Scene::materials`].
    pub material: usize,
}

/// A mesh placed in the world.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Name for messages.
    pub name: String,
    /// Index in [`Scene::meshes`].
    pub mesh: usize,
    /// Object to world; may mirror and scale non-uniformly.
    pub transform: DAffine3,
    /// Whether it may move from frame to frame.
    pub moving: bool,
}

/// A light without a surface of its own in the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Name for messages.
    pub name: String,
    /// Where it is and how it spreads.
    pub kind: LightKind,
    /// Directional: irradiance at normal incidence, W·m⁻². Point and spot: radiant intensity, W·sr⁻¹.
    pub intensity: Vec3,
}

/// The kinds of lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// A far disc.
    Directional {
        /// The way the light travels, unit.
        direction: Vec3,
        /// Full angle of the disc, radians; 0 for a point.
        angular_diameter: f32,
    },
    /// A sphere.
    Point {
        /// Centre, world space.
        position: DVec3,
        /// Radius in world units; 0 for a point.
        radius: f32,
    },
    /// A sphere behind a cone-shaped shade, glTF's falloff.
    Spot {
        /// Centre, world space.
        position: DVec3,
        /// Axis, the way the light travels, unit.
        direction: Vec3,
        /// Radius in world units; 0 for a point.
        radius: f32,
        /// Half-angle up to which it is full, radians.
        inner: f32,
        /// Half-angle from which it is none, radians, above `inner` and at most π/2.
        outer: f32,
    },
}

/// A pinhole camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Name for `--camera`.
    pub name: String,
    /// Pinhole, world space.
    pub eye: DVec3,
    /// Unit view direction.
    pub forward: Vec3,
    /// Unit, orthogonal to `forward`.
    pub up: Vec3,
    /// Full vertical angle of view, radians, in (0, π).
    pub vertical_fov: f32,
}

/// Instances flattened to world-space triangles, relative to `origin`. Mirrored instances have
/// their triangles turned, so that counter-clockwise stays the front.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// World position of this geometry's (0,0,0).
    pub origin: DVec3,
    /// Vertex positions less `origin`.
    pub positions: Vec<Vec3>,
    /// Unit normals.
    pub normals: Vec<Vec3>,
    /// Unit tangents, bitangent's sign in w.
    pub tangents: Vec<Vec4>,
    /// Texture coordinates.
    pub uvs: Vec<Vec2>,
    /// Material of each vertex's mesh.
    pub materials: Vec<u32>,
    /// Vertex indices, counter-clockwise from the front.
    pub triangles: Vec<[u32; 3]>,
}

/// A planar convex polygon (3 or 4 corners) that emits constant radiance from its front, or from both sides.
#[derive(Clone, Debug, PartialEq)]
pub struct EmissivePolygon {
    /// Corners, counter-clockwise from the front, relative to the geometry's origin.
    pub corners: Vec<Vec3>,
    /// Emitted radiance, W·m⁻²·sr⁻¹.
    pub radiance: Vec3,
    /// Whether both sides emit.
    pub double_sided: bool,
}
