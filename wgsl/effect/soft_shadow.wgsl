// Soft shadows (RAU §6.2): the share of each light that the surface sees, 1 unshadowed, by one cone as wide as
// the light. Layer k has lights 4k to 4k+3 in its channels; channels without a light repeat the first of
// the layer.

import package::common::cone::{Cone, ConeSettings, STEPPER_SPHERES, cone_trace};
import package::common::frame::frame;
import package::common::light::{Incidence, Light, area_corners, area_incidence, light_incidence, lights, HAS_AREA, LIGHT_AREA};
import package::common::quad::quarter;
import package::common::surface::Surface;

struct Params {
    /// Step over cell size.
    step: f32,
    /// Distance along the normal at which the cone begins, in voxels.
    start: f32,
}

fn cone_visibility(surface: Surface, incidence: Incidence, params: Params) -> f32 {
    let slope = dot(surface.normal_geometric, incidence.direction);
    if (all(incidence.irradiance <= vec3f(0.0)) || slope <= 0.0) {
        return 0.0;
    }
    let sine = incidence.tangent * inverseSqrt(1.0 + incidence.tangent * incidence.tangent);
    let origin = surface.position_voxel + surface.normal_geometric * params.start;
    // Ends short of the light's own voxels.
    let reach = incidence.distance / frame.voxel_size - params.start - 1.0;
    let cone = Cone(origin, incidence.direction, sine, 0.0, reach, params.start, slope);
    return 1.0 - cone_trace(cone, ConeSettings(STEPPER_SPHERES, params.step), 0.0).a;
}

fn light_visibility(surface: Surface, light: Light, params: Params) -> f32 {
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        // Its quarters, each by what it gives.
        let corners = area_corners(light);
        var arriving = 0.0;
        var possible = 0.0;
        for (var q = 0u; q < 4; q++) {
            let part = area_incidence(quarter(corners, q), light, surface.position, surface.normal);
            let weight = part.irradiance.r + part.irradiance.g + part.irradiance.b;
            possible += weight;
            arriving += weight * cone_visibility(surface, part, params);
        }
        return arriving / max(possible, 1e-30);
    }
    return cone_visibility(surface, light_incidence(light, surface.position, surface.normal), params);
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let first = surface.layer * 4;
    var visibility = vec4f(light_visibility(surface, lights[first], params));
    for (var i = 1u; i < 4 && first + i < frame.light_count; i++) {
        visibility[i] = light_visibility(surface, lights[first + i], params);
    }
    return visibility;
}
