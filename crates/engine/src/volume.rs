//! Buffers and volumes of a plan that are written and read from outside.

use half::f16;
use voxlume_graph::ResourceKind;

use crate::resources::Object;
use crate::{Error, Gpu, Renderer};

/// One mip level of a volume.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    /// Texels along x, y, z.
    pub size: [u32; 3],
    /// Their values, x fastest.
    pub values: Vec<[f32; 4]>,
}

impl Renderer<'_> {
    /// Writes the first bytes of a buffer of the plan. Passes that read it run again.
    ///
    /// # Errors
    /// The plan has no such buffer, or a smaller one.
    pub fn write_buffer(&mut self, name: &str, bytes: &[u8]) -> Result<(), Error> {
        let Some((index, Object::Buffer(buffer))) = self.session.object(name) else {
            return Err(Error::NoSuchBuffer(name.to_owned()));
        };
        self.gpu.guarded(name, || self.gpu.queue.write_buffer(buffer, 0, bytes))?;
        self.session.work.schedule.touch(index);
        Ok(())
    }

    /// The volumes of the plan: index and name, and what the largest of their bytes stand for.
    fn volumes(&self) -> impl Iterator<Item = (usize, &str, [f32; 4], &wgpu::Texture)> {
        let resources = self.plan().resources.iter().enumerate();
        resources.filter_map(|(index, resource)| {
            let ResourceKind::Volume { encoding, numbers, .. } = &resource.kind else { return None };
            let texture = self.session.work.resources.texture(index)?;
            Some((index, resource.name.as_str(), numbers.ranges(*encoding), texture))
        })
    }

    /// Fills all volumes with zeroes. Passes that read them run again; those that make them don't.
    ///
    /// # Errors
    /// The device is lost.
    pub fn clear_volumes(&mut self) -> Result<(), Error> {
        let mut cleared = Vec::new();
        for (index, name, _, texture) in self.volumes() {
            for mip in 0..texture.mip_level_count() {
                let (size, layout) = layout(texture, mip);
                let row = layout.bytes_per_row.unwrap_or(0);
                let zeroes = vec![0; (row * size.height * size.depth_or_array_layers) as usize];
                let to = wgpu::TexelCopyTextureInfo { mip_level: mip, ..texture.as_image_copy() };
                self.gpu.guarded(name, || self.gpu.queue.write_texture(to, &zeroes, layout, size))?;
            }
            cleared.push(index);
        }
        cleared.into_iter().for_each(|index| self.session.work.schedule.touch(index));
        Ok(())
    }

    /// Reads all mip levels of a volume of the plan.
    ///
    /// # Errors
    /// The plan has no such volume, or the device is lost.
    pub fn volume(&self, name: &str) -> Result<Vec<Texels>, Error> {
        let Some((_, _, ranges, texture)) = self.volumes().find(|(_, volume, ..)| *volume == name) else {
            let known = self.volumes().map(|(_, name, ..)| name.to_owned()).collect();
            return Err(Error::NoSuchImage { name: name.to_owned(), known });
        };
        (0..texture.mip_level_count()).map(|mip| read(self.gpu, texture, mip, ranges)).collect()
    }
}

/// Size of a mip level, and how its rows lie in a buffer.
fn layout(texture: &wgpu::Texture, mip: u32) -> (wgpu::Extent3d, wgpu::TexelCopyBufferLayout) {
    let size = texture.size().mip_level_size(mip, wgpu::TextureDimension::D3);
    let texel = texture.format().block_copy_size(None).unwrap_or(4);
    let row = (size.width * texel).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(row),
        rows_per_image: Some(size.height),
    };
    (size, layout)
}

fn read(gpu: &Gpu, texture: &wgpu::Texture, mip: u32, ranges: [f32; 4]) -> Result<Texels, Error> {
    let (size, layout) = layout(texture, mip);
    let row = layout.bytes_per_row.unwrap_or(0) as usize;
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("texels"),
        size: row as u64 * u64::from(size.height) * u64::from(size.depth_or_array_layers),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let from = wgpu::TexelCopyTextureInfo { mip_level: mip, ..texture.as_image_copy() };
    encoder.copy_texture_to_buffer(from, wgpu::TexelCopyBufferInfo { buffer: &buffer, layout }, size);
    gpu.guarded("reading a volume", || gpu.queue.submit([encoder.finish()]))?;
    let bytes = gpu.read(&buffer)?;
    let format = texture.format();
    let texel = format.block_copy_size(None).unwrap_or(4) as usize;
    let used = size.width as usize * texel;
    let rows = bytes.chunks_exact(row).flat_map(|row| row[..used].chunks_exact(texel));
    Ok(Texels {
        size: [size.width, size.height, size.depth_or_array_layers],
        values: rows.map(|texel| decode(format, ranges, texel)).collect(),
    })
}

/// As `decode_texel` in `wgsl/encoding`.
fn decode(format: wgpu::TextureFormat, ranges: [f32; 4], texel: &[u8]) -> [f32; 4] {
    std::array::from_fn(|i| match format {
        wgpu::TextureFormat::Rgba8Snorm => (f32::from(texel[i] as i8) / 127.0).max(-1.0) * ranges[i],
        wgpu::TextureFormat::Rgba8Unorm => f32::from(texel[i]) / 255.0 * ranges[i],
        wgpu::TextureFormat::Rgba32Float => {
            f32::from_le_bytes(std::array::from_fn(|byte| texel[4 * i + byte]))
        }
        _ => f16::from_le_bytes([texel[2 * i], texel[2 * i + 1]]).to_f32(),
    })
}
