// SH sampling: the radiance that leaves against the direction of travel (RAU §5.2.3). Two bands of a one-sided
// emitter overshoot to 1.25 ahead and −0.25 behind; what is negative is clamped to zero.

import package::common::volume_sampler::volume_sampler;
import package::format::basis::{COEFFICIENTS, SH0, SH1};

@group(2) @binding(1) var base: texture_3d<f32>;
@group(2) @binding(2) var harmonics: texture_3d<f32>;

fn sample_coefficient(index: u32, uvw: vec3f, level: f32, half_texel: f32) -> vec4f {
    // Half a texel from its block's ends, so that the filter never mixes two coefficients.
    let w = clamp(uvw.z, half_texel, 1.0 - half_texel);
    return textureSampleLevel(harmonics, volume_sampler, vec3f(uvw.xy, (f32(index) + w) / f32(COEFFICIENTS)), level);
}

// `level` counts from the coefficients' first, which is level 1 of the grid.
fn sample_harmonics(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let depth = f32(textureDimensions(harmonics).x >> u32(ceil(level)));
    let half_texel = 0.5 / max(depth, 1.0);
    let c0 = sample_coefficient(0, uvw, level, half_texel);
    let cx = sample_coefficient(1, uvw, level, half_texel);
    let cy = sample_coefficient(2, uvw, level, half_texel);
    let cz = sample_coefficient(3, uvw, level, half_texel);
    let slope = direction.x * cx.rgb + direction.y * cy.rgb + direction.z * cz.rgb;
    let opacity = dot(direction * direction, vec3f(cx.a, cy.a, cz.a));
    let radiance = max(SH0 * c0.rgb - SH1 * slope, vec3f(0.0)) / max(c0.a, 1e-6);
    return vec4f(radiance * opacity, opacity);
}

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    if (level <= 0.0) {
        return textureSampleLevel(base, volume_sampler, uvw, 0.0);
    }
    let coarsest = f32(textureNumLevels(harmonics) - 1);
    let coarse = sample_harmonics(uvw, clamp(level - 1.0, 0.0, coarsest), direction);
    if (level >= 1.0) {
        return coarse;
    }
    return mix(textureSampleLevel(base, volume_sampler, uvw, 0.0), coarse, level);
}
