// Lights, and the irradiance they would give without anything in between.

import package::common::constants::PI;
import package::common::grid::grid;
import package::common::polygon::polygon_irradiance;

const LIGHT_DIRECTIONAL = 0u;
const LIGHT_POINT = 1u;
const LIGHT_SPOT = 2u;
// An emissive quad or triangle (its last corner twice).
const LIGHT_AREA = 3u;

struct Light {
    // World units; for a directional light the unit direction towards it.
    position: vec3f,
    kind: u32,
    // Directional: irradiance at normal incidence, W·m⁻². Point, spot: W·sr⁻¹. Area: radiance, W·m⁻²·sr⁻¹.
    intensity: vec3f,
    // Directional: tangent of the half-angle. Point, spot: radius. Area: 1 where both sides emit.
    size: f32,
    // Spot: the axis along which it shines. Area: unit normal.
    direction: vec3f,
    // First layer in `shadow_maps`; negative: none.
    shadow_layer: i32,
    // Spot: glTF's angular falloff is saturate(cos·x + y)². Of many emissive polygons: the power of all up to this and its own, as
    // shares of all power.
    falloff: vec2f,
    area: f32,
    padding: f32,
    // Area: of its polygon. Others: the first has the width of a shadow map in world units, or at a unit's distance; the
    // world units of a directional light's depth from 0 to 1; and 1 where it is too wide for its map.
    corners: array<vec4f, 4>,
}

// Whether its shadow map says how soft its shadows are.
fn has_sharp_map(light: Light) -> bool {
    return light.shadow_layer >= 0 && light.corners[0].z == 0.0;
}

var<storage, read> lights: array<Light>;

// A scene without a kind of light has no branch for it.
override HAS_DIRECTIONAL: bool = true;
override HAS_POINT: bool = true;
override HAS_SPOT: bool = true;
override HAS_AREA: bool = true;

// The light as seen from a point.
struct Incidence {
    // Unit, towards the light.
    direction: vec3f,
    // To the light's centre, world units.
    distance: f32,
    // Sine of half the angle that the light spans.
    sine: f32,
    // On the surface, unoccluded, W·m⁻².
    irradiance: vec3f,
}

// An area light's normal on the side that is seen along a direction: the observer may be behind a light of two sides.
fn facing_normal(light: Light, direction: vec3f) -> vec3f {
    return select(-light.direction, light.direction, dot(light.direction, direction) < 0.0);
}

fn area_corners(light: Light) -> array<vec3f, 4> {
    return array(light.corners[0].xyz, light.corners[1].xyz, light.corners[2].xyz, light.corners[3].xyz);
}

// A part of an area light by its corners; `irradiance` is what a part that lies before the surface gives.
fn area_part(corners: array<vec3f, 4>, light: Light, position: vec3f, irradiance: vec3f) -> Incidence {
    let centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    let offset = centre - position;
    let distance = max(length(offset), 1e-20);
    let direction = offset / distance;
    let facing = -dot(direction, light.direction);
    let area = 0.5 * length(cross(corners[2] - corners[0], corners[3] - corners[1]));
    // The disc of the same solid angle, to first order.
    let tangent = sqrt(area * abs(facing) / PI) / distance;
    return Incidence(direction, distance, sine_of(tangent), select(vec3f(0.0), irradiance, facing > 0.0 || light.size > 0.0));
}

fn sine_of(tangent: f32) -> f32 {
    return tangent * inverseSqrt(1.0 + tangent * tangent);
}

// Mean of the cosine with a normal, as far as it is positive, over a disc in the sky, over what it is where the disc is straight above
// a surface: Snyder, "Area Light Sources for Real-Time Graphics", Microsoft Research MSR-TR-96-11, 1996, as Lagarde and de Rousiers
// write it ("Moving Frostbite to PBR", 2014, listing 9). `cosine` is that of the disc's middle, `half_sine` that of its half angle.
fn disc_cosine(cosine: f32, half_sine: f32) -> f32 {
    let sine2 = half_sine * half_sine;
    if (cosine * cosine >= sine2) {
        return max(cosine, 0.0);
    }
    let sine = sqrt(1.0 - cosine * cosine);
    let x = sqrt(max(1.0 / sine2 - 1.0, 0.0));
    let y = clamp(-x * cosine / sine, -1.0, 1.0);
    let edge = sine * sqrt(1.0 - y * y);
    return max((cosine * acos(y) - x * edge + atan2(edge, x) / sine2) / PI, 0.0);
}

// Far more than places are rounded by, voxels.
const COPLANAR = 0.01;

fn light_incidence(light: Light, position: vec3f, normal: vec3f) -> Incidence {
    if (HAS_DIRECTIONAL && light.kind == LIGHT_DIRECTIONAL) {
        let half_sine = sine_of(light.size);
        let cosine = disc_cosine(dot(light.position, normal), half_sine);
        return Incidence(light.position, 1e30, half_sine, light.intensity * cosine);
    }
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        let corners = area_corners(light);
        var irradiance = polygon_irradiance(corners, position, normal);
        // Nothing arrives along the light's own plane; rounding would put an observer there on either side of it.
        if (abs(dot(position - light.position, light.direction)) < COPLANAR * grid.voxel_size) {
            irradiance = 0.0;
        }
        return area_part(corners, light, position, light.intensity * irradiance);
    }
    let offset = light.position - position;
    // Within its sphere a light is no brighter than at its surface.
    let distance = max(length(offset), 1e-20);
    let nearest = max(distance, light.size);
    let direction = offset / distance;
    let half_sine = light.size / nearest;
    let cosine = disc_cosine(dot(direction, normal), half_sine);
    var irradiance = light.intensity * cosine / max(nearest * nearest, 1e-30);
    if (HAS_SPOT && light.kind == LIGHT_SPOT) {
        let shade = saturate(-dot(direction, light.direction) * light.falloff.x + light.falloff.y);
        irradiance *= shade * shade;
    }
    return Incidence(direction, distance, half_sine, irradiance);
}
