// The hemisphere as six cones of 60° (RAU eq. 6.8), weighted by their share of the cosine lobe (RAU eq. 6.9
// over π): 1/4 for the axis, 3/20 for each of the five around it. The weights sum to 1.

import package::common::basis::basis_around;
import package::common::cone::{Cone, ConeSettings, cone_trace, surface_cone};
import package::common::constants::PI;
import package::common::frame::frame;

const DIFFUSE_CONES = 6;
const DIFFUSE_SINE = 0.5;

fn diffuse_direction(index: i32) -> vec3f {
    let directions = array(
        vec3f(0.0, 0.0, 1.0),
        vec3f(0.0, 0.866025, 0.5),
        vec3f(0.823639, 0.267617, 0.5),
        vec3f(0.509037, -0.700629, 0.5),
        vec3f(-0.509037, -0.700629, 0.5),
        vec3f(-0.823639, 0.267617, 0.5),
    );
    return directions[index];
}

fn diffuse_weight(index: i32) -> f32 {
    return select(0.15, 0.25, index == 0);
}

// Cone `index` of a surface point.
fn diffuse_cone(p_voxel: vec3f, tangents: mat3x3f, index: i32, start: f32, reach: f32) -> Cone {
    return surface_cone(p_voxel, tangents[2], tangents * diffuse_direction(index), DIFFUSE_SINE, reach, start);
}

// Irradiance from the volume and the sky, W·m⁻², and the mean opacity.
fn gather_diffuse(p_voxel: vec3f, normal: vec3f, settings: ConeSettings, start: f32) -> vec4f {
    let tangents = basis_around(normal);
    var sum = vec4f(0.0);
    for (var i = 0; i < DIFFUSE_CONES; i++) {
        let value = cone_trace(diffuse_cone(p_voxel, tangents, i, start, 1e30), settings, 0.0);
        sum += diffuse_weight(i) * vec4f(value.rgb + (1.0 - value.a) * frame.sky, value.a);
    }
    return vec4f(PI * sum.rgb, sum.a);
}
