// The device filters: linear in space and between levels, clamped at the borders.

var volume_sampler: sampler;

fn filter_volume(volume: texture_3d<f32>, uvw: vec3f, level: f32) -> vec4f {
    return textureSampleLevel(volume, volume_sampler, uvw, level);
}
