//! Hashes of everything that decides a picture.

use glam::{DAffine3, DVec3, Vec2, Vec3, Vec4};
use voxlume_scene::{Instance, Light, LightKind, Material, Mesh, Scene, Texture, TextureRef};

use crate::request::{Gather, Panel, PixelSampling, Quantity, Reflection, Request};

/// Raised whenever the tracer's results change for the same scene and request.
const VERSION: u32 = 2;

/// The hash of a scene's content: names, cameras and what moves don't count, since they change no
/// picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SceneDigest([u8; 32]);

/// The hash of a scene's content, a request and the tracer's version.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Key(pub(crate) [u8; 32]);

impl SceneDigest {
    /// Hashes a scene, at about a gigabyte a second.
    pub fn of(scene: &Scene) -> Self {
        // Taken apart by name, here and below, so that a new field can't be forgotten.
        let Scene { name: _, materials, textures, meshes, instances, lights, sky, cameras: _, animation: _ } =
            scene;
        let mut hash = Hash::default();
        hash.list(materials, Hash::material);
        hash.list(textures, Hash::texture);
        hash.list(meshes, Hash::mesh);
        hash.list(instances, Hash::instance);
        hash.list(lights, Hash::light);
        hash.vec3(*sky);
        SceneDigest(hash.finish())
    }
}

impl Key {
    /// The key of the picture of a scene.
    pub fn new(scene: &SceneDigest, request: &Request) -> Self {
        let Request { camera, width, height, samples, seed, sampling, quantity, reflection } = request;
        let voxlume_scene::Camera { name: _, eye, forward, up, vertical_fov } = camera;
        let mut hash = Hash::default();
        hash.bytes(&VERSION.to_le_bytes());
        hash.bytes(&scene.0);
        hash.dvec3(*eye);
        hash.vec3(*forward);
        hash.vec3(*up);
        hash.floats(&[*vertical_fov]);
        for count in [*width, *height, *samples] {
            hash.bytes(&count.to_le_bytes());
        }
        hash.bytes(&seed.to_le_bytes());
        hash.bytes(&[match sampling {
            PixelSampling::Centre => 0,
            PixelSampling::Area => 1,
        }]);
        hash.quantity(quantity);
        hash.bytes(&[match reflection {
            Reflection::Gltf => 0,
            Reflection::Lambert => 1,
        }]);
        Key(hash.finish())
    }

    /// 64 hexadecimal digits.
    pub fn to_hex(&self) -> String {
        self.0.iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

/// BLAKE3 over little-endian numbers; lists carry their length.
#[derive(Default)]
struct Hash(blake3::Hasher);

impl Hash {
    fn finish(self) -> [u8; 32] {
        *self.0.finalize().as_bytes()
    }

    fn bytes(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    fn count(&mut self, count: usize) {
        self.bytes(&(count as u64).to_le_bytes());
    }

    fn list<T>(&mut self, items: &[T], each: fn(&mut Self, &T)) {
        self.count(items.len());
        items.iter().for_each(|item| each(self, item));
    }

    fn floats(&mut self, values: &[f32]) {
        values.iter().for_each(|value| self.bytes(&value.to_le_bytes()));
    }

    fn vec3(&mut self, v: Vec3) {
        self.floats(&v.to_array());
    }

    fn dvec3(&mut self, v: DVec3) {
        v.to_array().iter().for_each(|value| self.bytes(&value.to_le_bytes()));
    }

    fn texture_ref(&mut self, texture: &Option<TextureRef>) {
        self.count(texture.map_or(0, |TextureRef { texture }| texture + 1));
    }

    fn material(&mut self, material: &Material) {
        let Material {
            name: _,
            base_color,
            base_color_texture,
            metallic,
            roughness,
            metallic_roughness_texture,
            normal_texture,
            normal_scale,
            emission,
            emission_texture,
            alpha_cutoff,
            double_sided,
        } = material;
        self.floats(&base_color.to_array());
        self.texture_ref(base_color_texture);
        self.floats(&[*metallic, *roughness]);
        self.texture_ref(metallic_roughness_texture);
        self.texture_ref(normal_texture);
        self.floats(&[*normal_scale]);
        self.vec3(*emission);
        self.texture_ref(emission_texture);
        self.bytes(&[u8::from(alpha_cutoff.is_some()), u8::from(*double_sided)]);
        self.floats(&[alpha_cutoff.unwrap_or(0.0)]);
    }

    fn texture(&mut self, texture: &Texture) {
        let Texture { name: _, width, height, rgba, srgb } = texture;
        self.bytes(&width.to_le_bytes());
        self.bytes(&height.to_le_bytes());
        self.count(rgba.len());
        self.bytes(rgba);
        self.bytes(&[u8::from(*srgb)]);
    }

    fn mesh(&mut self, mesh: &Mesh) {
        let Mesh { name: _, positions, normals, tangents, uvs, triangles, material } = mesh;
        self.list(positions, |hash, v: &Vec3| hash.vec3(*v));
        self.list(normals, |hash, v: &Vec3| hash.vec3(*v));
        self.list(tangents, |hash, v: &Vec4| hash.floats(&v.to_array()));
        self.list(uvs, |hash, v: &Vec2| hash.floats(&v.to_array()));
        self.list(triangles, |hash, corners| corners.iter().for_each(|i| hash.bytes(&i.to_le_bytes())));
        self.count(*material);
    }

    fn instance(&mut self, instance: &Instance) {
        let Instance { name: _, mesh, transform, moving: _ } = instance;
        let DAffine3 { matrix3, translation } = transform;
        self.count(*mesh);
        for column in [matrix3.x_axis, matrix3.y_axis, matrix3.z_axis, *translation] {
            self.dvec3(column);
        }
    }

    fn light(&mut self, light: &Light) {
        let Light { name: _, kind, intensity } = light;
        self.vec3(*intensity);
        match *kind {
            LightKind::Directional { direction, angular_diameter } => {
                self.bytes(&[0]);
                self.vec3(direction);
                self.floats(&[angular_diameter]);
            }
            LightKind::Point { position, radius } => {
                self.bytes(&[1]);
                self.dvec3(position);
                self.floats(&[radius]);
            }
            LightKind::Spot { position, direction, radius, inner, outer } => {
                self.bytes(&[2]);
                self.dvec3(position);
                self.vec3(direction);
                self.floats(&[radius, inner, outer]);
            }
        }
    }

    fn quantity(&mut self, quantity: &Quantity) {
        match *quantity {
            Quantity::SoftShadow { light } => {
                self.bytes(&[6]);
                self.count(light);
            }
            Quantity::AmbientOcclusion { distance, falloff } => {
                self.bytes(&[1]);
                self.floats(&[distance, falloff]);
            }
            Quantity::PanelShadow(Panel { corners, double_sided }) => {
                self.bytes(&[5, u8::from(double_sided)]);
                corners.iter().for_each(|corner| self.dvec3(*corner));
            }
            Quantity::Diffuse(gather) => self.gather(2, gather),
            Quantity::Specular(gather) => self.gather(3, gather),
            Quantity::Final { bounces } => {
                self.bytes(&[4]);
                self.bytes(&bounces.to_le_bytes());
            }
        }
    }

    fn gather(&mut self, kind: u8, Gather { bounces, sky, emission }: Gather) {
        self.bytes(&[kind, u8::from(sky), u8::from(emission)]);
        self.bytes(&bounces.to_le_bytes());
    }
}
