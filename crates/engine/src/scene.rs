//! The scene on the device: what the engine supplies to a plan under the names of WGSL's variables.

use glam::DVec3;
use voxlume_graph::{Plan, SceneFacts};
use voxlume_scene::{Camera, Geometry, Instance, LightKind, Scene};

use crate::Error;
use crate::host::Host;
use crate::resources::Object;
use crate::schedule::Versions;
use crate::upload::{frame, light, material, mesh, texture};

/// The scene's buffers and textures.
#[derive(Debug)]
pub(crate) struct SceneObjects {
    pub indices: wgpu::Buffer,
    pub index_count: u32,
    vertices: wgpu::Buffer,
    materials: wgpu::Buffer,
    color_textures: wgpu::Texture,
    data_textures: wgpu::Texture,
    material_sampler: wgpu::Sampler,
    volume_sampler: wgpu::Sampler,
    shadow_sampler: wgpu::Sampler,
    camera: Written,
    clock: Written,
    environment: Written,
    lights: Written,
    shadow_matrices: Written,
    /// Vertices and triangles of instances that don't move.
    still: (usize, usize),
    /// As they are on the device.
    instances: Vec<Instance>,
    /// What positions are relative to.
    origin: DVec3,
}

/// A buffer, and what it holds.
#[derive(Debug)]
struct Written {
    buffer: wgpu::Buffer,
    bytes: Vec<u8>,
}

impl Written {
    fn new(host: &mut Host, label: &str, bytes: &[u8], usage: wgpu::BufferUsages) -> Result<Written, Error> {
        Ok(Written { buffer: host.buffer_with(label, bytes, usage)?, bytes: bytes.to_vec() })
    }

    /// Writes as many bytes as there are, if they differ; whether they do.
    fn write(&mut self, host: &mut Host, bytes: &[u8]) -> bool {
        let differs = self.bytes != bytes;
        if differs {
            host.write(&self.buffer, 0, bytes);
            self.bytes.copy_from_slice(bytes);
        }
        differs
    }
}

impl SceneObjects {
    pub fn new(
        host: &mut Host,
        plan: &Plan,
        facts: &SceneFacts,
        scene: &Scene,
    ) -> Result<SceneObjects, Error> {
        let origin = plan.grid.centre;
        let (vertices, indices, still) = whole(scene, origin);
        let (storage, uniform) = (wgpu::BufferUsages::STORAGE, wgpu::BufferUsages::UNIFORM);
        let layers = texture::layers(scene);
        let [colors, data] = [true, false].map(|srgb| texture::array(scene, srgb, facts.texture_size));
        let lights = light::lights(scene, plan, facts);
        let environment = frame::Environment { sky: scene.sky, light_count: lights.count };
        let index_usage = storage | wgpu::BufferUsages::INDEX;
        let repeat = wgpu::AddressMode::Repeat;
        let clamp = wgpu::AddressMode::ClampToEdge;
        let nothing = [0; size_of::<frame::Camera>()];
        Ok(SceneObjects {
            index_count: indices.len() as u32 * 3,
            indices: host.buffer_with("indices", bytemuck::cast_slice(&indices), index_usage)?,
            vertices: host.buffer_with("vertices", bytemuck::cast_slice(&vertices), storage)?,
            materials: host.buffer_with(
                "materials",
                bytemuck::cast_slice(&material::materials(scene, &layers)),
                storage,
            )?,
            color_textures: texture_array(host, "color_textures", &colors, true)?,
            data_textures: texture_array(host, "data_textures", &data, false)?,
            material_sampler: sampler(host, repeat, None),
            volume_sampler: sampler(host, clamp, None),
            shadow_sampler: sampler(host, clamp, Some(wgpu::CompareFunction::LessEqual)),
            camera: Written::new(host, "camera", &nothing, uniform)?,
            clock: Written::new(host, "clock", &[0; size_of::<frame::Clock>()], uniform)?,
            environment: Written::new(host, "environment", bytemuck::bytes_of(&environment), uniform)?,
            lights: Written::new(host, "lights", bytemuck::cast_slice(&lights.lights), storage)?,
            shadow_matrices: Written::new(
                host,
                "shadow_matrices",
                bytemuck::cast_slice(&lights.matrices),
                storage,
            )?,
            still,
            instances: scene.instances.clone(),
            origin,
        })
    }

    /// What a plan calls by this name; `None` for what no scene has.
    pub fn object(&self, name: &str) -> Option<Object> {
        let buffer = |buffer: &wgpu::Buffer| Some(Object::Buffer(buffer.clone()));
        let texture = |texture: &wgpu::Texture| Some(Object::Texture(texture.clone()));
        let sampler = |sampler: &wgpu::Sampler| Some(Object::Sampler(sampler.clone()));
        match name {
            "camera" => buffer(&self.camera.buffer),
            "clock" => buffer(&self.clock.buffer),
            "environment" => buffer(&self.environment.buffer),
            "lights" => buffer(&self.lights.buffer),
            "shadow_matrices" => buffer(&self.shadow_matrices.buffer),
            "vertices" => buffer(&self.vertices),
            "indices" => buffer(&self.indices),
            "materials" => buffer(&self.materials),
            "color_textures" => texture(&self.color_textures),
            "data_textures" => texture(&self.data_textures),
            "material_sampler" => sampler(&self.material_sampler),
            "volume_sampler" => sampler(&self.volume_sampler),
            "shadow_sampler" => sampler(&self.shadow_sampler),
            _ => None,
        }
    }

    /// Writes where the camera is.
    pub fn look(&mut self, host: &mut Host, plan: &Plan, camera: &Camera, versions: &mut Versions) {
        let camera = frame::Camera::new(plan, camera);
        versions.camera += u64::from(self.camera.write(host, bytemuck::bytes_of(&camera)));
    }

    /// Writes the time.
    pub fn tick(&mut self, host: &mut Host, seconds: f32, frame: u32) {
        self.clock.write(host, bytemuck::bytes_of(&frame::Clock::new(seconds, frame)));
    }

    /// Writes where moving instances and lights are now, as far as it has changed.
    ///
    /// # Errors
    /// The scene differs in more than that; then nothing is written.
    pub fn update(
        &mut self,
        host: &mut Host,
        plan: &Plan,
        facts: &SceneFacts,
        scene: &Scene,
        versions: &mut Versions,
    ) -> Result<(), Error> {
        scene.check_frame()?;
        let lights = light::lights(scene, plan, facts);
        self.is_same_scene(plan, facts, scene, lights.count)?;
        self.write_lights(host, scene, &lights, versions);
        if self.stand_as_in(scene) {
            return Ok(());
        }
        self.instances = scene.instances.clone();
        versions.geometry += 1;
        let geometry = Geometry::moving(scene, plan.grid.centre);
        let (first_vertex, first_triangle) = self.still;
        let mut triangles = geometry.triangles.clone();
        masked_last(scene, &geometry, &mut triangles);
        triangles.iter_mut().flatten().for_each(|index| *index += first_vertex as u32);
        let vertices = mesh::vertices(&geometry);
        let (vertex, triangle) = (size_of::<mesh::Vertex>(), size_of::<[u32; 3]>());
        host.write(&self.vertices, (first_vertex * vertex) as u64, bytemuck::cast_slice(&vertices));
        // A mirrored instance's triangles are turned.
        host.write(&self.indices, (first_triangle * triangle) as u64, bytemuck::cast_slice(&triangles));
        Ok(())
    }

    /// Takes over another plan of the same scene: lights may be others, and positions relative to another origin.
    ///
    /// # Errors
    /// As [`SceneObjects::update`]; or the device refuses a buffer.
    pub fn replan(
        &mut self,
        host: &mut Host,
        plan: &Plan,
        facts: &SceneFacts,
        scene: &Scene,
    ) -> Result<(), Error> {
        scene.check_frame()?;
        let lights = light::lights(scene, plan, facts);
        self.is_same_scene(plan, facts, scene, lights.count)?;
        let storage = wgpu::BufferUsages::STORAGE;
        let bytes: &[u8] = bytemuck::cast_slice(&lights.lights);
        if bytes.len() != self.lights.bytes.len() {
            self.lights = Written::new(host, "lights", bytes, storage)?;
        }
        self.write_lights(host, scene, &lights, &mut Versions::default());
        if !self.stand_as_in(scene) || plan.grid.centre != self.origin {
            let (vertices, indices, _) = whole(scene, plan.grid.centre);
            host.write(&self.vertices, 0, bytemuck::cast_slice(&vertices));
            host.write(&self.indices, 0, bytemuck::cast_slice(&indices));
            (self.instances, self.origin) = (scene.instances.clone(), plan.grid.centre);
        }
        Ok(())
    }

    fn write_lights(
        &mut self,
        host: &mut Host,
        scene: &Scene,
        lights: &light::Lights,
        versions: &mut Versions,
    ) {
        let environment = frame::Environment { sky: scene.sky, light_count: lights.count };
        let changed = [
            self.lights.write(host, bytemuck::cast_slice(&lights.lights)),
            self.shadow_matrices.write(host, bytemuck::cast_slice(&lights.matrices)),
            self.environment.write(host, bytemuck::bytes_of(&environment)),
        ];
        versions.lights += u64::from(changed.contains(&true));
    }

    /// Whether all instances are where they are on the device.
    fn stand_as_in(&self, scene: &Scene) -> bool {
        let pairs = self.instances.iter().zip(&scene.instances);
        pairs.into_iter().all(|(known, instance)| known.transform == instance.transform)
    }

    /// Whether a scene is the one that was uploaded, but for what may differ from frame to frame.
    fn is_same_scene(
        &self,
        plan: &Plan,
        facts: &SceneFacts,
        scene: &Scene,
        lights: u32,
    ) -> Result<(), Error> {
        let other = |message: String| Err(Error::OtherScene(message));
        let meshes = || scene.instances.iter().map(|instance| &scene.meshes[instance.mesh]);
        let punctual = |kind: fn(&LightKind) -> bool| {
            scene.lights.iter().filter(|light| kind(&light.kind)).count() as u32
        };
        let point = punctual(|kind| matches!(kind, LightKind::Point { .. }));
        let spot = punctual(|kind| matches!(kind, LightKind::Spot { .. }));
        let polygons = if plan.area_lights { facts.polygons.unwrap_or(0) } else { 0 };
        let triangles = meshes().map(|mesh| mesh.triangles.len() as u32).sum();
        let vertices = meshes().map(|mesh| mesh.positions.len() as u32).sum();
        for (what, is, was) in [
            ("lights", lights, facts.punctual() + polygons),
            ("point lights", point, facts.point),
            ("spot lights", spot, facts.spot),
            ("triangles", triangles, facts.triangles),
            ("vertices", vertices, facts.vertices),
            ("instances", scene.instances.len() as u32, self.instances.len() as u32),
        ] {
            if is != was {
                return other(format!("it has {is} {what} instead of {was}"));
            }
        }
        for (instance, known) in scene.instances.iter().zip(&self.instances) {
            if (instance.mesh, instance.moving) != (known.mesh, known.moving) {
                return other(format!("`{}` is another instance", instance.name));
            }
            if !instance.moving && instance.transform != known.transform {
                return other(format!("`{}` has moved and is not marked as moving", instance.name));
            }
        }
        if scene.sky.max_element() > 0.0 && !facts.sky {
            return other("its sky shines, and was dark".into());
        }
        Ok(())
    }
}

/// All vertices and triangles, and how many of each never move.
fn whole(scene: &Scene, origin: DVec3) -> (Vec<mesh::Vertex>, Vec<[u32; 3]>, (usize, usize)) {
    let (geometry, moving) = (Geometry::new(scene, origin), Geometry::moving(scene, origin));
    let still = (
        geometry.positions.len() - moving.positions.len(),
        geometry.triangles.len() - moving.triangles.len(),
    );
    let mut triangles = geometry.triangles.clone();
    let (never, may) = triangles.split_at_mut(still.1);
    masked_last(scene, &geometry, never);
    masked_last(scene, &geometry, may);
    (mesh::vertices(&geometry), triangles, still)
}

/// As the plan has them voxelized apart.
fn masked_last(scene: &Scene, geometry: &Geometry, triangles: &mut [[u32; 3]]) {
    triangles.sort_by_key(|triangle| {
        scene.materials[geometry.materials[triangle[0] as usize] as usize].is_masked()
    });
}

fn sampler(host: &Host, address: wgpu::AddressMode, compare: Option<wgpu::CompareFunction>) -> wgpu::Sampler {
    host.gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        address_mode_u: address,
        address_mode_v: address,
        address_mode_w: address,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        compare,
        ..Default::default()
    })
}

fn texture_array(
    host: &mut Host,
    label: &str,
    array: &texture::TextureArray,
    srgb: bool,
) -> Result<wgpu::Texture, Error> {
    let format = if srgb { wgpu::TextureFormat::Rgba8UnormSrgb } else { wgpu::TextureFormat::Rgba8Unorm };
    let texture = host.texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: array.size, height: array.size, depth_or_array_layers: array.layers },
        mip_level_count: array.levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })?;
    for (mip, bytes) in array.levels.iter().enumerate() {
        let side = (array.size >> mip).max(1);
        host.write_texture(
            wgpu::TexelCopyTextureInfo { mip_level: mip as u32, ..texture.as_image_copy() },
            bytes,
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(4 * side),
                rows_per_image: Some(side),
            },
            wgpu::Extent3d { width: side, height: side, depth_or_array_layers: array.layers },
        );
    }
    Ok(texture)
}
