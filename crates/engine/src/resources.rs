//! A plan's resources on the device.

use voxlume_format::{Encoding, Numbers, Texel};
use voxlume_graph::{ImageTexel, Life, Plan, ResourceKind};

use crate::Error;
use crate::host::Host;

/// A resource.
#[derive(Clone, Debug)]
pub(crate) enum Object {
    Buffer(wgpu::Buffer),
    Texture(wgpu::Texture),
    Sampler(wgpu::Sampler),
    /// Not made yet: its size depends on the number of occupied voxels.
    Pending,
}

/// All of a plan's, by their index in it.
#[derive(Debug)]
pub(crate) struct Resources(Vec<Slot>);

/// A resource, or two that change places: see [`Life::History`].
#[derive(Debug)]
struct Slot {
    objects: Vec<Object>,
    newest: usize,
}

impl Resources {
    /// Without those of the scene, which are given, and those whose size depends on the number of voxels.
    pub fn new(
        host: &mut Host,
        plan: &Plan,
        scene: impl Fn(&str) -> Option<Object>,
    ) -> Result<Resources, Error> {
        let all = plan.resources.iter().enumerate().map(|(index, resource)| match resource.kind {
            ResourceKind::Scene => {
                let object = scene(&resource.name).unwrap_or(Object::Pending);
                Ok(Slot { objects: vec![object], newest: 0 })
            }
            ResourceKind::PerVoxel(_) | ResourceKind::PerCell(_) => {
                Ok(Slot { objects: vec![Object::Pending], newest: 0 })
            }
            _ => slot(host, plan, index, (0, 0)),
        });
        Ok(Resources(all.collect::<Result<_, _>>()?))
    }

    /// The value that was written last.
    pub fn newest(&self, index: usize) -> &Object {
        let Slot { objects, newest } = &self.0[index];
        &objects[*newest]
    }

    /// The value before that.
    pub fn last(&self, index: usize) -> &Object {
        let Slot { objects, newest } = &self.0[index];
        &objects[(newest + 1) % objects.len()]
    }

    /// Which of two is the newest.
    pub fn place(&self, index: usize) -> usize {
        self.0[index].newest
    }

    /// Lets the newest value become the last one: a pass is about to write the resource.
    pub fn turn(&mut self, index: usize) {
        let slot = &mut self.0[index];
        slot.newest = (slot.newest + 1) % slot.objects.len();
    }

    /// Makes some anew, or none of them if one can't be made. `counts` are of occupied voxels and cells.
    pub fn remake(
        &mut self,
        host: &mut Host,
        plan: &Plan,
        which: &[usize],
        counts: (u64, u64),
    ) -> Result<(), Error> {
        let made = which.iter().map(|index| slot(host, plan, *index, counts));
        let made = made.collect::<Result<Vec<_>, _>>()?;
        which.iter().zip(made).for_each(|(index, slot)| self.0[*index] = slot);
        Ok(())
    }

    /// Puts an object in a resource's place.
    pub fn put(&mut self, index: usize, object: Object) {
        self.0[index] = Slot { objects: vec![object], newest: 0 };
    }

    pub fn buffer(&self, index: usize) -> Option<&wgpu::Buffer> {
        match self.newest(index) {
            Object::Buffer(buffer) => Some(buffer),
            _ => None,
        }
    }

    pub fn texture(&self, index: usize) -> Option<&wgpu::Texture> {
        match self.newest(index) {
            Object::Texture(texture) => Some(texture),
            _ => None,
        }
    }
}

fn slot(host: &mut Host, plan: &Plan, index: usize, counts: (u64, u64)) -> Result<Slot, Error> {
    let copies = match plan.resources[index].life {
        Life::Frame | Life::Kept => 1,
        Life::History => 2,
    };
    let objects = (0..copies).map(|_| create(host, plan, index, counts)).collect::<Result<_, _>>()?;
    Ok(Slot { objects, newest: 0 })
}

fn create(host: &mut Host, plan: &Plan, index: usize, (voxels, cells): (u64, u64)) -> Result<Object, Error> {
    let resource = &plan.resources[index];
    let name = resource.name.as_str();
    let mut texture = |[width, height, depth_or_array_layers]: [u32; 3], mips, dimension, format, usage| {
        let descriptor = wgpu::TextureDescriptor {
            label: Some(name),
            size: wgpu::Extent3d { width, height, depth_or_array_layers },
            mip_level_count: mips,
            sample_count: 1,
            dimension,
            format,
            usage: usage | wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        };
        host.texture(&descriptor).map(Object::Texture)
    };
    match &resource.kind {
        ResourceKind::Scene => Ok(Object::Pending),
        ResourceKind::Uniform(bytes) => {
            host.buffer_with(name, bytes, wgpu::BufferUsages::UNIFORM).map(Object::Buffer)
        }
        ResourceKind::Buffer(bytes) | ResourceKind::PerVoxel(bytes) | ResourceKind::PerCell(bytes) => {
            let bytes = match resource.kind {
                ResourceKind::PerVoxel(_) => bytes * voxels,
                ResourceKind::PerCell(_) => bytes * cells,
                _ => *bytes,
            }
            .max(32);
            let limit = host.gpu.device.limits().max_storage_buffer_binding_size;
            if bytes > limit {
                return Err(Error::TooLarge { name: name.to_owned(), bytes, voxels, limit });
            }
            let usage = wgpu::BufferUsages::STORAGE
                | wgpu::BufferUsages::COPY_DST
                | wgpu::BufferUsages::COPY_SRC
                | wgpu::BufferUsages::INDIRECT;
            host.buffer(name, bytes, usage).map(Object::Buffer)
        }
        ResourceKind::Volume { size, mips, encoding, numbers } => {
            let format = volume_format(*encoding, *numbers);
            let usage = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::COPY_DST;
            texture(*size, *mips, wgpu::TextureDimension::D3, format, usage)
        }
        ResourceKind::Image { extent, texel, layers, mips } => {
            let [width, height] = extent.size(plan.screen);
            let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
            let is_writable = ImageTexel::WRITABLE.contains(texel);
            let usage = if is_writable { drawn | wgpu::TextureUsages::STORAGE_BINDING } else { drawn };
            let format = image_format(*texel);
            texture([width, height, *layers], *mips, wgpu::TextureDimension::D2, format, usage)
        }
        ResourceKind::Raster { side } => {
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
            texture([*side, *side, 1], 1, wgpu::TextureDimension::D2, RASTER_FORMAT, usage)
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
        ImageTexel::Rgba32Float => wgpu::TextureFormat::Rgba32Float,
        ImageTexel::Rg32Float => wgpu::TextureFormat::Rg32Float,
        ImageTexel::R32Float => wgpu::TextureFormat::R32Float,
        ImageTexel::R32Uint => wgpu::TextureFormat::R32Uint,
        ImageTexel::Rgba8Unorm => wgpu::TextureFormat::Rgba8Unorm,
        ImageTexel::Rgba8Srgb => wgpu::TextureFormat::Rgba8UnormSrgb,
        ImageTexel::Depth32 => wgpu::TextureFormat::Depth32Float,
    }
}
