//! Images as layers of two arrays, one of sRGB colours and one of linear data. A layer has the arrays' common
//! size: texture coordinates run from 0 to 1 whatever the size, so stretching an image changes nothing else.

use image::imageops::{FilterType, resize};
use image::{ImageBuffer, Rgba};
use rayon::prelude::*;
use voxlume_scene::{Scene, Texture};

/// All mip levels of all layers, level by level.
pub(crate) struct TextureArray {
    pub size: u32,
    pub layers: u32,
    pub levels: Vec<Vec<u8>>,
}

/// Each texture's layer in the array of its class.
pub(crate) fn layers(scene: &Scene) -> Vec<i32> {
    let mut next = [0, 0];
    let class = |texture: &Texture| usize::from(!texture.srgb);
    scene
        .textures
        .iter()
        .map(|texture| {
            let layer = next[class(texture)];
            next[class(texture)] += 1;
            layer
        })
        .collect()
}

pub(crate) fn array(scene: &Scene, srgb: bool, size: u32) -> TextureArray {
    let chains: Vec<Vec<Vec<u8>>> = scene
        .textures
        .par_iter()
        .filter(|texture| texture.srgb == srgb)
        .map(|texture| chain(texture, size))
        .collect();
    if chains.is_empty() {
        return TextureArray { size: 1, layers: 1, levels: vec![vec![255; 4]] };
    }
    let levels =
        (0..chains[0].len()).map(|level| chains.iter().flat_map(|c| c[level].iter().copied()).collect());
    TextureArray { size, layers: chains.len() as u32, levels: levels.collect() }
}

fn chain(texture: &Texture, size: u32) -> Vec<Vec<u8>> {
    let mut level = if (texture.width, texture.height) == (size, size) {
        texture.rgba.clone()
    } else {
        ImageBuffer::<Rgba<u8>, &[u8]>::from_raw(texture.width, texture.height, texture.rgba.as_slice())
            .map(|image| resize(&image, size, size, FilterType::Triangle).into_raw())
            // The loader checked the length.
            .unwrap_or_else(|| vec![255; (size * size * 4) as usize])
    };
    let mut levels = Vec::new();
    let mut side = size as usize;
    while side > 1 {
        let next = halve(&level, side, texture.srgb);
        levels.push(std::mem::replace(&mut level, next));
        side /= 2;
    }
    levels.push(level);
    levels
}

/// The mean of each 2 × 2 texels; of colours, the mean of the light.
fn halve(level: &[u8], side: usize, srgb: bool) -> Vec<u8> {
    let half = side / 2;
    let mut next = Vec::with_capacity(half * half * 4);
    for y in 0..half {
        for x in 0..half {
            for channel in 0..4 {
                let texel = |dx, dy| level[((2 * y + dy) * side + 2 * x + dx) * 4 + channel];
                let four = [texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)];
                next.push(if srgb && channel < 3 {
                    encode_srgb(four.iter().map(|v| decode_srgb(*v)).sum::<f32>() / 4.0)
                } else {
                    // To even, or what is rounded up on every level would tilt normal maps.
                    (four.iter().map(|v| f32::from(*v)).sum::<f32>() / 4.0).round_ties_even() as u8
                });
            }
        }
    }
    next
}

fn decode_srgb(value: u8) -> f32 {
    static TABLE: std::sync::LazyLock<[f32; 256]> = std::sync::LazyLock::new(|| {
        std::array::from_fn(|i| {
            let v = i as f32 / 255.0;
            if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
        })
    });
    TABLE[usize::from(value)]
}

fn encode_srgb(light: f32) -> u8 {
    let v = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (v * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding cancels over the levels: a mean of 4096 texels of noise is as good as one rounded once, within a step.
    #[test]
    fn the_topmost_level_is_the_mean() {
        let side = 64;
        let noise = |i: u32| (i.wrapping_mul(0x9e37_79b9) >> 24) as u8;
        for srgb in [false, true] {
            let rgba: Vec<u8> = (0..4 * side * side).map(noise).collect();
            let texture =
                Texture { name: String::new(), width: side, height: side, rgba: rgba.clone(), srgb };
            let levels = chain(&texture, side);
            for (channel, top) in levels[6].iter().enumerate() {
                let light = |v: &u8| if srgb && channel < 3 { decode_srgb(*v) } else { f32::from(*v) };
                let values = rgba.iter().skip(channel).step_by(4).map(light);
                let mean = values.sum::<f32>() / (side * side) as f32;
                let expected = if srgb && channel < 3 { f32::from(encode_srgb(mean)) } else { mean };
                let top = f32::from(*top);
                assert!((top - expected).abs() <= 1.0, "{top} and not {expected} in channel {channel}");
            }
        }
    }
}
