// Soft shadows (RAU §6.2): the share of each light's irradiance that arrives, 1 unshadowed, by a trace as wide as
// the light or, interleaved, as a part of it. Layer k has lights 4k to 4k+3 in its channels; channels without a light repeat the first of
// the layer.

import package::common::environment::environment;
import package::common::grid::{grid, to_voxel};
import package::common::light::{Incidence, Light, facing_normal, light_incidence, lights, has_sharp_map, HAS_AREA, LIGHT_AREA};
import package::common::light_part::light_part;
import package::common::surface::{Surface, surface_apex};
import package::common::trace::{cone_lobe, reach_of, reach_up_to, turn_of};
import package::tracer::trace::trace_opacity;

struct Params {
    /// Parts of a light along each of its sides, [1, 4]: a pixel's traces are as wide as one of them, and the pass's
    /// `interleave` takes the mean over all.
    parts: u32,
    /// Which lights: all, or those that are too wide for a shadow map; `all` unless given.
    lights: u32,
}

const LIGHTS_ALL = 0u;
const LIGHTS_WIDE = 1u;

fn traced_visibility(surface: Surface, light: Light, incidence: Incidence) -> f32 {
    let slope = dot(surface.normal_geometric, incidence.direction);
    if (all(incidence.irradiance <= vec3f(0.0)) || slope <= 0.0) {
        return 0.0;
    }
    var reach = reach_of(incidence.distance / grid.voxel_size);
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        reach = reach_up_to(to_voxel(light.position), facing_normal(light, incidence.direction));
    }
    let part = cone_lobe(incidence.direction, incidence.sine);
    return 1.0 - trace_opacity(surface_apex(surface), part, reach, 0.0);
}

fn light_visibility(surface: Surface, light: Light, params: Params) -> f32 {
    if (params.lights == LIGHTS_WIDE && has_sharp_map(light)) {
        return 1.0;
    }
    let whole = light_incidence(light, surface.position, surface.normal);
    if (all(whole.irradiance <= vec3f(0.0))) {
        return 0.0;
    }
    let part = light_part(light, whole, params.parts, turn_of(surface.share), surface.position, surface.normal);
    return traced_visibility(surface, light, part);
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let first = surface.layer * 4;
    var visibility = vec4f(light_visibility(surface, lights[first], params));
    for (var i = 1u; i < 4 && first + i < environment.light_count; i++) {
        visibility[i] = light_visibility(surface, lights[first + i], params);
    }
    return visibility;
}
