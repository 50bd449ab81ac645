//! Images read back from the device.

use half::f16;

use crate::{Error, Gpu};

/// An image of linear values, row-major from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `width * height` pixels.
    pub pixels: Vec<[f32; 4]>,
}

/// Bytes of a texture with its levels and layers.
pub(crate) fn texture_bytes(texture: &wgpu::Texture) -> u64 {
    let size = texture.size();
    let texel = u64::from(texture.format().block_copy_size(None).unwrap_or(4));
    let level = |mip: u32| u64::from((size.width >> mip).max(1)) * u64::from((size.height >> mip).max(1));
    (0..texture.mip_level_count()).map(level).sum::<u64>() * u64::from(size.depth_or_array_layers) * texel
}

/// Reads the first layer.
pub(crate) fn read(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Picture, Error> {
    let (width, height) = (texture.width(), texture.height());
    let texel = texture.format().block_copy_size(None).unwrap_or(4);
    let row = (width * texel).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("picture"),
        size: u64::from(row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row),
                rows_per_image: Some(height),
            },
        },
        wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
    );
    gpu.guarded("reading an image", || gpu.queue.submit([encoder.finish()]))?;
    let bytes = gpu.read(&buffer)?;
    let format = texture.format();
    let pixels = bytes
        .chunks_exact(row as usize)
        .flat_map(|row| row[..(width * texel) as usize].chunks_exact(texel as usize))
        .map(|texel| decode(format, texel))
        .collect();
    Ok(Picture { width, height, pixels })
}

/// A texel's values; those that it doesn't have are 0.
fn decode(format: wgpu::TextureFormat, texel: &[u8]) -> [f32; 4] {
    let word = |i: usize| -> [u8; 4] { std::array::from_fn(|byte| texel[4 * i + byte]) };
    let words = texel.len() / 4;
    match format {
        wgpu::TextureFormat::Rgba16Float => {
            std::array::from_fn(|i| f16::from_le_bytes([texel[2 * i], texel[2 * i + 1]]).to_f32())
        }
        wgpu::TextureFormat::Depth32Float => {
            let depth = f32::from_le_bytes(word(0));
            [depth, depth, depth, 1.0]
        }
        wgpu::TextureFormat::R32Uint => [u32::from_le_bytes(word(0)) as f32, 0.0, 0.0, 0.0],
        wgpu::TextureFormat::Rgba8Unorm => std::array::from_fn(|i| f32::from(texel[i]) / 255.0),
        wgpu::TextureFormat::Rgba8UnormSrgb => std::array::from_fn(|i| {
            let value = f32::from(texel[i]) / 255.0;
            match i {
                3 => value,
                _ if value <= 0.04045 => value / 12.92,
                _ => ((value + 0.055) / 1.055).powf(2.4),
            }
        }),
        // Single-precision floats: one, two or four.
        _ => std::array::from_fn(|i| if i < words { f32::from_le_bytes(word(i)) } else { 0.0 }),
    }
}
