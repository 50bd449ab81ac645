//! Textures and samplers of a scene.

use crate::Error;
use crate::host::Host;
use crate::upload::texture::TextureArray;

pub(super) fn sampler(
    host: &Host,
    address: wgpu::AddressMode,
    compare: Option<wgpu::CompareFunction>,
) -> wgpu::Sampler {
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

pub(super) fn texture_array(
    host: &mut Host,
    label: &str,
    array: &TextureArray,
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
