//! A plan's resources on the device.

use voxlume_format::{Encoding, Numbers, Texel};
use voxlume_graph::{ImageTexel, Plan, ResourceKind, SceneFacts};
use voxlume_scene::{Geometry, Scene};

use crate::upload::{light, material, mesh, texture};
use crate::{Error, Gpu};

/// A resource.
#[derive(Debug)]
pub(crate) enum Object {
    Buffer(wgpu::Buffer),
    Texture(wgpu::Texture),
    Sampler(wgpu::Sampler),
    /// Not made yet: its size depends on the number of occupied voxels.
    Pending,
}

/// The scene's part: what the plan calls `Scene` resources, and what else drawing needs.
pub(crate) struct SceneObjects {
    pub named: Vec<(&'static str, Object)>,
    pub indices: wgpu::Buffer,
    pub index_count: u32,
    pub light_count: u32,
    pub frame: wgpu::Buffer,
    vertices: wgpu::Buffer,
    lights: wgpu::Buffer,
    shadow_matrices: wgpu::Buffer,
    /// Vertices and triangles of instances that don't move.
    still: (usize, usize),
}

impl SceneObjects {
    pub fn new(gpu: &Gpu, plan: &Plan, facts: &SceneFacts, scene: &Scene) -> Result<SceneObjects, Error> {
        let geometry = Geometry::new(scene, plan.grid.centre);
        let lights = light::lights(scene, plan, facts);
        let layers = texture::layers(scene);
        let [colors, data] = [true, false].map(|srgb| texture::array(scene, srgb, facts.texture_size));
        gpu.guarded("the scene's buffers", || {
            let storage = |label, bytes: &[u8], usage| buffer_with(gpu, label, bytes, usage);
            let read = wgpu::BufferUsages::STORAGE;
            // What an update writes.
            let kept = read | wgpu::BufferUsages::COPY_DST;
            let moving = Geometry::moving(scene, plan.grid.centre);
            let still = (
                geometry.positions.len() - moving.positions.len(),
                geometry.triangles.len() - moving.triangles.len(),
            );
            let mut triangles = geometry.triangles.clone();
            let (never, may) = triangles.split_at_mut(still.1);
            masked_last(scene, &geometry, never);
            masked_last(scene, &geometry, may);
            let indices: &[u8] = bytemuck::cast_slice(&triangles);
            let index_buffer = storage("indices", indices, kept | wgpu::BufferUsages::INDEX);
            let frame = gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("frame"),
                size: size_of::<crate::upload::frame::Frame>() as u64,
                usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            let vertices = storage("vertices", bytemuck::cast_slice(&mesh::vertices(&geometry)), kept);
            let light_buffer = storage("lights", bytemuck::cast_slice(&lights.lights), kept);
            let shadow_matrices = storage("shadow_matrices", bytemuck::cast_slice(&lights.matrices), kept);
            let named = vec![
                ("frame", Object::Buffer(frame.clone())),
                ("vertices", Object::Buffer(vertices.clone())),
                ("indices", Object::Buffer(index_buffer.clone())),
                (
                    "materials",
                    Object::Buffer(storage(
                        "materials",
                        bytemuck::cast_slice(&material::materials(scene, &layers)),
                        read,
                    )),
                ),
                ("lights", Object::Buffer(light_buffer.clone())),
                ("shadow_matrices", Object::Buffer(shadow_matrices.clone())),
                ("color_textures", Object::Texture(texture_array(gpu, "color_textures", &colors, true))),
                ("data_textures", Object::Texture(texture_array(gpu, "data_textures", &data, false))),
                ("material_sampler", Object::Sampler(sampler(gpu, wgpu::AddressMode::Repeat, None))),
                ("volume_sampler", Object::Sampler(sampler(gpu, wgpu::AddressMode::ClampToEdge, None))),
                (
                    "shadow_sampler",
                    Object::Sampler(sampler(
                        gpu,
                        wgpu::AddressMode::ClampToEdge,
                        Some(wgpu::CompareFunction::LessEqual),
                    )),
                ),
            ];
            SceneObjects {
                named,
                indices: index_buffer,
                index_count: geometry.triangles.len() as u32 * 3,
                light_count: lights.count,
                frame,
                vertices,
                lights: light_buffer,
                shadow_matrices,
                still,
            }
        })
    }

    /// Writes where the scene's moving instances and its lights are now.
    pub fn update(&self, gpu: &Gpu, plan: &Plan, facts: &SceneFacts, scene: &Scene) -> Result<(), Error> {
        let lights = light::lights(scene, plan, facts);
        let geometry = Geometry::moving(scene, plan.grid.centre);
        let (first_vertex, first_triangle) = self.still;
        let mut triangles = geometry.triangles.clone();
        masked_last(scene, &geometry, &mut triangles);
        triangles.iter_mut().flatten().for_each(|index| *index += first_vertex as u32);
        let known = (self.light_count, self.index_count as usize / 3);
        let (lit, shown) = (lights.count, first_triangle + triangles.len());
        if (lit, shown) != known {
            let message =
                format!("{lit} lights and {shown} triangles, where there were {} and {}", known.0, known.1);
            return Err(Error::Refused { what: "the scene's update".into(), message });
        }
        let write =
            |buffer, offset: usize, bytes: &[u8]| gpu.queue.write_buffer(buffer, offset as u64, bytes);
        let vertices = mesh::vertices(&geometry);
        write(&self.vertices, first_vertex * size_of::<mesh::Vertex>(), bytemuck::cast_slice(&vertices));
        // A mirrored instance's triangles are turned.
        write(&self.indices, first_triangle * size_of::<[u32; 3]>(), bytemuck::cast_slice(&triangles));
        write(&self.lights, 0, bytemuck::cast_slice(&lights.lights));
        write(&self.shadow_matrices, 0, bytemuck::cast_slice(&lights.matrices));
        Ok(())
    }
}

/// As the plan has them voxelized apart.
fn masked_last(scene: &Scene, geometry: &Geometry, triangles: &mut [[u32; 3]]) {
    triangles.sort_by_key(|triangle| {
        scene.materials[geometry.materials[triangle[0] as usize] as usize].is_masked()
    });
}

/// A buffer with these bytes, at least one element's worth of zeroes.
pub(crate) fn buffer_with(gpu: &Gpu, label: &str, bytes: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let nothing = [0; 256];
    let contents = if bytes.is_empty() { &nothing } else { bytes };
    // `create_buffer_init` would panic if the device is lost.
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: contents.len() as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, contents);
    buffer
}

fn sampler(gpu: &Gpu, address: wgpu::AddressMode, compare: Option<wgpu::CompareFunction>) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
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

fn texture_array(gpu: &Gpu, label: &str, array: &texture::TextureArray, srgb: bool) -> wgpu::Texture {
    let format = if srgb { wgpu::TextureFormat::Rgba8UnormSrgb } else { wgpu::TextureFormat::Rgba8Unorm };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: array.size, height: array.size, depth_or_array_layers: array.layers },
        mip_level_count: array.levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (mip, bytes) in array.levels.iter().enumerate() {
        let side = (array.size >> mip).max(1);
        gpu.queue.write_texture(
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
    texture
}

/// Makes resource `index`; with `counts` of occupied voxels and cells, also what depends on them.
pub(crate) fn create(
    gpu: &Gpu,
    plan: &Plan,
    index: usize,
    counts: Option<(u64, u64)>,
) -> Result<Object, Error> {
    let resource = &plan.resources[index];
    let name = resource.name.as_str();
    if matches!(resource.kind, ResourceKind::PerVoxel(_) | ResourceKind::PerCell(_)) && counts.is_none() {
        return Ok(Object::Pending);
    }
    let (voxels, cells) = counts.unwrap_or_default();
    let [width, height] = plan.screen;
    let texture = |size: [u32; 3], mips, dimension, format, usage| {
        let [width, height, depth_or_array_layers] = size;
        gpu.guarded(name, || {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(name),
                size: wgpu::Extent3d { width, height, depth_or_array_layers },
                mip_level_count: mips,
                sample_count: 1,
                dimension,
                format,
                usage: usage | wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC,
                view_formats: &[],
            })
        })
        .map(Object::Texture)
    };
    match resource.kind {
        ResourceKind::Scene => Ok(Object::Pending),
        ResourceKind::Buffer(_) | ResourceKind::PerVoxel(_) | ResourceKind::PerCell(_) => {
            let bytes = plan.bytes(index, voxels, cells).unwrap_or_default().max(32);
            let limit = gpu.device.limits().max_storage_buffer_binding_size;
            if bytes > limit {
                return Err(Error::TooLarge { name: name.to_owned(), bytes, voxels, limit });
            }
            let usage = wgpu::BufferUsages::STORAGE
                | wgpu::BufferUsages::COPY_DST
                | wgpu::BufferUsages::COPY_SRC
                | wgpu::BufferUsages::INDIRECT;
            let descriptor =
                wgpu::BufferDescriptor { label: Some(name), size: bytes, usage, mapped_at_creation: false };
            gpu.guarded(name, || gpu.device.create_buffer(&descriptor)).map(Object::Buffer)
        }
        ResourceKind::Volume { size, mips, encoding, numbers } => {
            let format = volume_format(encoding, numbers);
            let usage = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::COPY_DST;
            texture(size, mips, wgpu::TextureDimension::D3, format, usage)
        }
        ResourceKind::Image { texel, layers } => {
            let usage = match texel {
                ImageTexel::Rgba16Float => {
                    wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::RENDER_ATTACHMENT
                }
                ImageTexel::Rgba8Srgb | ImageTexel::Depth32 => wgpu::TextureUsages::RENDER_ATTACHMENT,
            };
            texture([width, height, layers], 1, wgpu::TextureDimension::D2, image_format(texel), usage)
        }
        ResourceKind::Raster { side } => {
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
            texture([side, side, 1], 1, wgpu::TextureDimension::D2, RASTER_FORMAT, usage)
        }
        ResourceKind::ShadowMaps { size, layers } => {
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
            texture(
                [size, size, layers],
                1,
                wgpu::TextureDimension::D2,
                wgpu::TextureFormat::Depth32Float,
                usage,
            )
        }
    }
}

/// The least that WebGPU renders to: a pass must have a target.
pub(crate) const RASTER_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

fn volume_format(encoding: Encoding, numbers: Numbers) -> wgpu::TextureFormat {
    match numbers.texel(encoding) {
        Texel::Rgba8Unorm => wgpu::TextureFormat::Rgba8Unorm,
        Texel::Rgba8Snorm => wgpu::TextureFormat::Rgba8Snorm,
        Texel::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
        Texel::Rgba32Float => wgpu::TextureFormat::Rgba32Float,
    }
}

pub(crate) fn image_format(texel: ImageTexel) -> wgpu::TextureFormat {
    match texel {
        ImageTexel::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
        ImageTexel::Rgba8Srgb => wgpu::TextureFormat::Rgba8UnormSrgb,
        ImageTexel::Depth32 => wgpu::TextureFormat::Depth32Float,
    }
}
