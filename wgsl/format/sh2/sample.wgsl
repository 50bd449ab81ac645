// SH sampling: the radiance that leaves against the direction of travel (RAU §5.2.3). Two bands of a one-sided
// emitter overshoot to 1.25 ahead and −0.25 behind. So they are read as what the sides show: band 1 says by how much
// opposite sides differ, and the rest of band 0 is both sides'. Nothing is negative, and a dark side beside lit ones stays dark.
// Or the bands are summed up in the direction (`bands`).

import package::common::isotropic_base::sample_over_base;
import package::common::volume::block_uvw;
import package::common::volume_sampler::volume_sampler;
import package::encoding::{decode_radiances, filter_volume};
import package::format::bands::radiance_by_bands;
import package::format::cell::{COVERAGE, Cell, HARMONICS, seen_from};
import package::format::options::{BASE, BASE_ISOTROPIC, NEGATIVES, NEGATIVES_SIDES};

var base: texture_3d<f32>;
var harmonics: texture_3d<f32>;
var coverage: texture_3d<f32>;

// By how much the positive side of an axis shows more, and of band 0 the colour with the axis' number. `level` counts from the
// coefficients' first, here and below.
fn harmonics_at(axis: u32, uvw: vec3f, level: f32) -> vec4f {
    return decode_radiances(filter_volume(harmonics, block_uvw(harmonics, axis, HARMONICS, uvw, level), level));
}

fn coverage_at(negative: bool, uvw: vec3f, level: f32) -> vec3f {
    let place = block_uvw(coverage, select(0u, 1u, negative), COVERAGE, uvw, level);
    return textureSampleLevel(coverage, volume_sampler, place, level).xyz;
}

fn cell_at(uvw: vec3f, level: f32) -> Cell {
    let x = harmonics_at(0, uvw, level);
    let y = harmonics_at(1, uvw, level);
    let z = harmonics_at(2, uvw, level);
    let band1 = mat3x3f(x.rgb, y.rgb, z.rgb);
    return Cell(vec3f(x.a, y.a, z.a), band1, coverage_at(false, uvw, level), coverage_at(true, uvw, level));
}

fn opacity_of_sides(uvw: vec3f, level: f32, direction: vec3f) -> f32 {
    let facing = select(coverage_at(false, uvw, level), coverage_at(true, uvw, level), direction > vec3f(0.0));
    return dot(facing, abs(direction));
}

// As far as they are opaque.
fn radiance_of_sides(uvw: vec3f, level: f32, direction: vec3f) -> vec3f {
    let c = cell_at(uvw, level);
    let value = seen_from(c, select(vec3f(-1.0), vec3f(1.0), direction > vec3f(0.0))) * abs(direction);
    if (NEGATIVES == NEGATIVES_SIDES) {
        return value.rgb / max(value.a, 1.0);
    }
    return radiance_by_bands(c, direction) * min(value.a, 1.0);
}

// Radiance and opacity are kept apart, so that what needs opacity alone fetches nothing else.
fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let coarse_level = select(level, max(level - 1.0, 0.0), BASE == BASE_ISOTROPIC);
    var radiance = radiance_of_sides(uvw, coarse_level, direction);
    var opacity = min(opacity_of_sides(uvw, coarse_level, direction), 1.0);
    if (BASE == BASE_ISOTROPIC && level < 1.0) {
        let fine = sample_over_base(base, uvw, level, vec4f(radiance, opacity));
        radiance = fine.rgb;
        opacity = fine.a;
    }
    return vec4f(radiance, opacity);
}
