// SH sampling: the radiance that leaves against the direction of travel (RAU §5.2.3), and the opacity of the sides towards
// the observer.

import package::common::isotropic_base::sample_over_base;
import package::common::volume::block_uvw;
import package::encoding::decode_radiances;
import package::filter::filter_volume;
import package::format::bands::radiance_by_bands;
import package::format::cell::{COVERAGE, Cell, HARMONICS};
import package::format::options::{BASE, BASE_ISOTROPIC};

var base: texture_3d<f32>;
var harmonics: texture_3d<f32>;
var coverage: texture_3d<f32>;

// Band 1 along an axis, and of band 0 the colour with the axis' number. `level` counts from the
// coefficients' first, here and below.
fn harmonics_at(axis: u32, uvw: vec3f, level: f32) -> vec4f {
    return decode_radiances(filter_volume(harmonics, block_uvw(harmonics, axis, HARMONICS, uvw, level), level));
}

fn coverage_at(negative: bool, uvw: vec3f, level: f32) -> vec3f {
    let place = block_uvw(coverage, select(0u, 1u, negative), COVERAGE, uvw, level);
    return filter_volume(coverage, place, level).xyz;
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

// Radiance and opacity are kept apart, so that what needs opacity alone fetches nothing else.
fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let coarse_level = select(level, max(level - 1.0, 0.0), BASE == BASE_ISOTROPIC);
    var opacity = min(opacity_of_sides(uvw, coarse_level, direction), 1.0);
    var radiance = opacity * radiance_by_bands(cell_at(uvw, coarse_level), direction);
    if (BASE == BASE_ISOTROPIC && level < 1.0) {
        let fine = sample_over_base(base, uvw, level, vec4f(radiance, opacity));
        radiance = fine.rgb;
        opacity = fine.a;
    }
    return vec4f(radiance, opacity);
}
