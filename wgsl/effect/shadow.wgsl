// Shadows as each light needs them: by its shadow map, which is exact for a light without size and says how soft the shadows of a
// small sun are; of lights that are too wide for one what was traced. Layer k has lights 4k to 4k+3 in its channels.

import package::common::basis::basis_around;
import package::common::constants::GOLDEN_ANGLE;
import package::common::environment::environment;
import package::common::light::{LIGHT_DIRECTIONAL, LIGHT_POINT, Light, has_sharp_map, light_incidence, lights};
import package::common::shadow_map::{cube_face, shadow_maps, shadow_matrices};
import package::common::surface::{Surface, image_texel, screen_pixel};

struct Params {
    /// Places on the surface at which a map is asked, [1, 64]; 16 unless given.
    taps: u32,
}

// The image of traced shadows.
var traced: texture_2d_array<f32>;
override HAS_TRACED: bool = false;
override HAS_SHADOW_MAPS: bool = true;

// A place as the map has it: across in [0, 1], and the depth.
fn map_place(layer: i32, position: vec3f) -> vec3f {
    let clip = shadow_matrices[layer] * vec4f(position, 1.0);
    return vec3f(clip.xy / clip.w * vec2f(0.5, -0.5) + 0.5, clip.z / clip.w);
}

// The plane of a surface as a map has it: a place on it, and how its depth changes across.
struct MapPlane {
    place: vec3f,
    slope: vec2f,
}

fn map_plane(layer: i32, position: vec3f, normal: vec3f, length: f32) -> MapPlane {
    let place = map_place(layer, position);
    let tangents = basis_around(normal);
    let a = map_place(layer, position + length * tangents[0]) - place;
    let b = map_place(layer, position + length * tangents[1]) - place;
    let area = a.x * b.y - a.y * b.x;
    let slope = vec2f(a.z * b.y - a.y * b.z, a.x * b.z - a.z * b.x) / select(area, 1e-20, abs(area) < 1e-20);
    return MapPlane(place, slope);
}

// How far before the plane lies what the map's texel shows, at the texel's middle; negative where it lies behind. So a plane never
// shades itself, however it is turned.
fn depth_before(layer: i32, plane: MapPlane, texel: vec2i) -> f32 {
    let size = vec2i(textureDimensions(shadow_maps));
    let inside = clamp(texel, vec2i(0), size - 1);
    let middle = (vec2f(inside) + 0.5) / vec2f(size);
    return plane.place.z + dot(plane.slope, middle - plane.place.xy) - textureLoad(shadow_maps, inside, layer, 0);
}

// The share of the four texels around a place that show nothing before the plane.
fn lit_around(layer: i32, plane: MapPlane) -> f32 {
    let at = plane.place.xy * vec2f(textureDimensions(shadow_maps)) - 0.5;
    let low = floor(at);
    let share = at - low;
    var lit = 0.0;
    for (var i = 0; i < 4; i++) {
        let corner = vec2i(i & 1, i >> 1);
        let weight = select(1.0 - share, share, corner == vec2i(1));
        lit += weight.x * weight.y * select(1.0, 0.0, depth_before(layer, plane, vec2i(low) + corner) > 0.0);
    }
    return lit;
}

// Texel number `index` of a disc of this radius about the plane's place, in texels.
fn texel_of(index: u32, params: Params, plane: MapPlane, radius: f32) -> vec2i {
    let angle = f32(index) * GOLDEN_ANGLE;
    let across = radius * sqrt((f32(index) + 0.5) / f32(params.taps)) * vec2f(cos(angle), sin(angle));
    return vec2i(floor(plane.place.xy * vec2f(textureDimensions(shadow_maps)) + across));
}

fn mapped_visibility(surface: Surface, light: Light, params: Params) -> f32 {
    let incidence = light_incidence(light, surface.position, surface.normal);
    if (all(incidence.irradiance <= vec3f(0.0)) || dot(surface.normal_geometric, incidence.direction) <= 0.0) {
        return 0.0;
    }
    var layer = light.shadow_layer;
    if (light.kind == LIGHT_POINT) {
        layer += cube_face(surface.position - light.position);
    }
    let is_sun = light.kind == LIGHT_DIRECTIONAL;
    let texel = light.corners[0].x * select(incidence.distance, 1.0, is_sun) / f32(textureDimensions(shadow_maps).x);
    // Curved surfaces lie beside their triangles' planes: half a texel towards the light leaves them unshaded.
    let position = surface.position + 0.5 * texel * incidence.direction;
    let plane = map_plane(layer, position, surface.normal_geometric, texel);
    if (any(plane.place != clamp(plane.place, vec3f(0.0), vec3f(1.0)))) {
        return 1.0;
    }
    if (!is_sun || light.size <= 0.0) {
        return lit_around(layer, plane);
    }
    // Percentage-closer soft shadows (Fernando 2005): how wide the penumbra is, by the blockers in as much of the map as it
    // could span; then how much of so wide a disc is free.
    let depth = light.corners[0].y;
    let widest = light.size * plane.place.z * depth / texel;
    var blockers = 0.0;
    var sum = 0.0;
    for (var i = 0u; i < params.taps; i++) {
        let before = depth_before(layer, plane, texel_of(i, params, plane, widest));
        blockers += select(0.0, 1.0, before > 0.0);
        sum += max(before, 0.0);
    }
    if (blockers == 0.0) {
        return 1.0;
    }
    let radius = light.size * (sum / blockers) * depth / texel;
    if (radius < 1.0) {
        return lit_around(layer, plane);
    }
    var lit = 0.0;
    for (var i = 0u; i < params.taps; i++) {
        lit += select(1.0, 0.0, depth_before(layer, plane, texel_of(i, params, plane, radius)) > 0.0);
    }
    return lit / f32(params.taps);
}

fn visibility(surface: Surface, index: u32, params: Params) -> f32 {
    let light = lights[index];
    if (HAS_SHADOW_MAPS && has_sharp_map(light)) {
        return mapped_visibility(surface, light, params);
    }
    if (HAS_TRACED) {
        return textureLoad(traced, image_texel(screen_pixel(surface.pixel, surface.image_size), textureDimensions(traced)), surface.layer, 0)[index % 4];
    }
    return 1.0;
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let first = surface.layer * 4;
    var value = vec4f(visibility(surface, first, params));
    for (var i = 1u; i < 4 && first + i < environment.light_count; i++) {
        value[i] = visibility(surface, first + i, params);
    }
    return value;
}
