// SH sampling: the radiance that leaves against the direction of travel (RAU §5.2.3). Two bands of a one-sided
// emitter overshoot to 1.25 ahead and −0.25 behind. So radiance is divided by what the same two bands give for a
// radiance of 1, which makes it exact for surfaces of one radiance. What is negative is clamped to zero, or band 1 is
// windowed so that nothing is: of a one-sided emitter 2/3 of it remains, which gives 1 ahead and 0 behind.

import package::common::isotropic_base::sample_over_base;
import package::common::seen_ahead::{SeenAhead, all_ahead};
import package::common::volume::sample_block;
import package::format::basis::{COEFFICIENTS, SH0, SH1, LOBE0, LOBE1, decode_opacity, mean_opacity};
import package::format::options::{BASE, BASE_ISOTROPIC, NEGATIVES, NEGATIVES_WINDOW};

// Whether opacity from level 1 up is that of a surface's front only, so that a cone may reach back to the surface
// that it leaves.
const VOXEL_ONE_SIDED = true;

@group(2) @binding(1) var base: texture_3d<f32>;
@group(2) @binding(2) var harmonics: texture_3d<f32>;

// The largest share of band 1, [0, 1], with which nothing is negative in any direction; of each channel.
fn window(band0: vec3f, size1: vec3f) -> vec3f {
    if (NEGATIVES != NEGATIVES_WINDOW) {
        return vec3f(1.0);
    }
    return saturate(band0 / max(size1, vec3f(1e-20)));
}

// `level` counts from the coefficients' first.
fn sample_harmonics(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let c0 = sample_block(harmonics, 0, COEFFICIENTS, uvw, level);
    let cx = sample_block(harmonics, 1, COEFFICIENTS, uvw, level);
    let cy = sample_block(harmonics, 2, COEFFICIENTS, uvw, level);
    let cz = sample_block(harmonics, 3, COEFFICIENTS, uvw, level);
    let alpha = vec4f(c0.a, cx.a, cy.a, cz.a);
    let six = decode_opacity(alpha);
    // The observer is where the ray comes from; a cell crossed at a slant is crossed on all three axes.
    let facing = select(six.positive, six.negative, direction > vec3f(0.0));
    let opacity = min(dot(abs(direction), facing), 1.0);
    let band0 = SH0 * c0.rgb;
    let band1 = SH1 * (direction.x * cx.rgb + direction.y * cy.rgb + direction.z * cz.rgb);
    let size1 = SH1 * sqrt(cx.rgb * cx.rgb + cy.rgb * cy.rgb + cz.rgb * cz.rgb);
    let radiance = band0 - window(band0, size1) * band1;
    // The same for a radiance of 1: from what both sides have as much goes ahead as back.
    let more = alpha.yzw;
    let lobe = (abs(more.x) + abs(more.y) + abs(more.z)) / 6.0;
    let mean = mean_opacity(alpha);
    let unit0 = SH0 * LOBE0 * mean;
    let unit1 = SH1 * LOBE1 * lobe;
    let unit = unit0 - window(vec3f(unit0), vec3f(unit1)).x * unit1 * dot(direction, more) / max(length(more), 1e-6);
    return vec4f(max(radiance, vec3f(0.0)) / max(unit, 0.35 * mean + 1e-6) * opacity, opacity);
}

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    if (BASE != BASE_ISOTROPIC) {
        return sample_harmonics(uvw, level, direction);
    }
    let coarse = sample_harmonics(uvw, max(level - 1.0, 0.0), direction);
    if (level >= 1.0) {
        return coarse;
    }
    return sample_over_base(base, uvw, level, coarse);
}

fn voxel_sample_ahead(uvw: vec3f, level: f32, direction: vec3f, apex: vec3f, behind: vec3f) -> SeenAhead {
    return all_ahead(voxel_sample(uvw, level, direction));
}
