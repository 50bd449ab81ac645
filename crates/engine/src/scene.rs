//! The scene on the device: what the engine supplies to a plan under the names of WGSL's variables.

mod same;
mod textures;

use glam::DVec3;
use voxlume_graph::{Plan, SceneFacts};
use voxlume_scene::{Camera, Instance, Scene};

use crate::Error;
use crate::host::{Host, Written};
use crate::resources::Object;
use crate::schedule::Versions;
use crate::upload::{frame, light, material, mesh, texture};

use same::Known;
use textures::{sampler, texture_array};

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
    /// That of the triangles that may move.
    order: Vec<u32>,
    /// As they are on the device.
    instances: Vec<Instance>,
    /// What positions are relative to.
    origin: DVec3,
}

impl SceneObjects {
    pub fn new(
        host: &mut Host,
        plan: &Plan,
        facts: &SceneFacts,
        scene: &Scene,
    ) -> Result<SceneObjects, Error> {
        let origin = plan.grid.centre;
        let mesh::Whole { vertices, triangles: indices, still, order } = mesh::whole(scene, origin);
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
                bytemuck::cast_slice(&light::padded(&lights.matrices)),
                uniform,
            )?,
            still,
            order,
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
        let lights = self.lights_of(plan, facts, scene)?;
        self.write_lights(host, scene, &lights, versions);
        if self.stand_as_in(scene) {
            return Ok(());
        }
        self.instances = scene.instances.clone();
        versions.geometry += 1;
        let (first_vertex, first_triangle) = self.still;
        let (vertices, triangles) = mesh::moving(scene, plan.grid.centre, first_vertex, &self.order);
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
        let lights = self.lights_of(plan, facts, scene)?;
        let storage = wgpu::BufferUsages::STORAGE;
        let bytes: &[u8] = bytemuck::cast_slice(&lights.lights);
        if bytes.len() != self.lights.bytes.len() {
            self.lights = Written::new(host, "lights", bytes, storage)?;
        }
        self.write_lights(host, scene, &lights, &mut Versions::default());
        if !self.stand_as_in(scene) || plan.grid.centre != self.origin {
            let mesh::Whole { vertices, triangles, order, .. } = mesh::whole(scene, plan.grid.centre);
            host.write(&self.vertices, 0, bytemuck::cast_slice(&vertices));
            host.write(&self.indices, 0, bytemuck::cast_slice(&triangles));
            self.order = order;
            (self.instances, self.origin) = (scene.instances.clone(), plan.grid.centre);
        }
        Ok(())
    }

    /// The lights of a scene, if it is the one on the device.
    fn lights_of(&self, plan: &Plan, facts: &SceneFacts, scene: &Scene) -> Result<light::Lights, Error> {
        scene.check_frame()?;
        let lights = light::lights(scene, plan, facts);
        let (instances, still_vertices) = (self.instances.as_slice(), self.still.0);
        Known { plan, facts, instances, still_vertices }.is(scene, lights.count)?;
        Ok(lights)
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
}
