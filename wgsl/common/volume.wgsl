// Volumes, whatever their encoding, as they are read; what writes one encodes the texel first. Positions are [0, 1]³, levels the texture's own.
// A volume may hold several blocks, one above the other along z.

import package::encoding::decode_texel;
import package::filter::filter_volume;

// A texel of the level that is bound.
fn load_volume(volume: texture_3d<f32>, texel: vec3u) -> vec4f {
    return decode_texel(textureLoad(volume, texel, 0));
}

// Linear in space and between levels, clamped at the borders.
fn sample_volume(volume: texture_3d<f32>, uvw: vec3f, level: f32) -> vec4f {
    return decode_texel(filter_volume(volume, uvw, level));
}

// A place in a block, half a texel from the block's ends, so that the filter never mixes two blocks.
fn block_uvw(volume: texture_3d<f32>, block: u32, blocks: u32, uvw: vec3f, level: f32) -> vec3f {
    let half_texel = 0.5 * exp2(ceil(level)) * f32(blocks) / f32(textureDimensions(volume).z);
    let w = clamp(uvw.z, half_texel, 1.0 - half_texel);
    return vec3f(uvw.xy, (f32(block) + w) / f32(blocks));
}

fn sample_block(volume: texture_3d<f32>, block: u32, blocks: u32, uvw: vec3f, level: f32) -> vec4f {
    return sample_volume(volume, block_uvw(volume, block, blocks, uvw, level), level);
}

// A cell's place in a block of a level with so many texels along z.
fn block_texel(cell: vec3u, block: u32, blocks: u32, depth: u32) -> vec3u {
    return cell + vec3u(0, 0, block * (depth / blocks));
}
