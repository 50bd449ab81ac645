// SH sampling: the radiance that leaves against the direction of travel (RAU §5.2.3). Two bands of a one-sided
// emitter overshoot to 1.25 ahead and −0.25 behind. So radiance is divided by what the same two bands give for a
// radiance of 1, which makes it exact for surfaces of one radiance; what is negative is clamped to zero.

import package::common::frame::frame;
import package::common::volume_sampler::volume_sampler;
import package::format::basis::{COEFFICIENTS, SH0, SH1, LOBE0, LOBE1, decode_opacity, mean_opacity};

// Whether opacity from level 1 up is that of a surface's front only, so that a cone may reach back to the surface
// that it leaves.
const VOXEL_ONE_SIDED = true;

@group(2) @binding(1) var base: texture_3d<f32>;
@group(2) @binding(2) var harmonics: texture_3d<f32>;

fn sample_coefficient(index: u32, uvw: vec3f, level: f32, half_texel: f32) -> vec4f {
    // Half a texel from its block's ends, so that the filter never mixes two coefficients.
    let w = clamp(uvw.z, half_texel, 1.0 - half_texel);
    return textureSampleLevel(harmonics, volume_sampler, vec3f(uvw.xy, (f32(index) + w) / f32(COEFFICIENTS)), level);
}

// `level` counts from the coefficients' first, which is level 1 of the grid.
fn sample_harmonics(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let half_texel = 0.5 * exp2(ceil(level)) / f32(frame.grid_size.z >> 1);
    let c0 = sample_coefficient(0, uvw, level, half_texel);
    let cx = sample_coefficient(1, uvw, level, half_texel);
    let cy = sample_coefficient(2, uvw, level, half_texel);
    let cz = sample_coefficient(3, uvw, level, half_texel);
    let alpha = vec4f(c0.a, cx.a, cy.a, cz.a);
    let six = decode_opacity(alpha);
    // The observer is where the ray comes from; a cell crossed at a slant is crossed on all three axes.
    let facing = select(six.positive, six.negative, direction > vec3f(0.0));
    let opacity = min(dot(abs(direction), facing), 1.0);
    let radiance = SH0 * c0.rgb - SH1 * (direction.x * cx.rgb + direction.y * cy.rgb + direction.z * cz.rgb);
    // The same for a radiance of 1: from what both sides have as much goes ahead as back.
    let more = alpha.yzw;
    let lobe = (abs(more.x) + abs(more.y) + abs(more.z)) / 6.0;
    let mean = mean_opacity(alpha);
    let unit = SH0 * LOBE0 * mean - SH1 * LOBE1 * lobe * dot(direction, more) / max(length(more), 1e-6);
    return vec4f(max(radiance, vec3f(0.0)) / max(unit, 0.35 * mean + 1e-6) * opacity, opacity);
}

// Level 0 is the same from all sides. Level 1 says from which it is seen at all: where that is a quarter or more,
// level 0 counts in full.
const FACING_FULL = 0.25;

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let coarse = sample_harmonics(uvw, max(level - 1.0, 0.0), direction);
    if (level >= 1.0) {
        return coarse;
    }
    let fine = textureSampleLevel(base, volume_sampler, uvw, 0.0) * saturate(coarse.a / FACING_FULL);
    return mix(fine, coarse, max(level, 0.0));
}
