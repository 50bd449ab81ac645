// The whole image from its parts (RAU eq. 7.3): emission + direct light × shadow + diffuse + specular.

import package::common::brdf::{brdf, diffuse_brdf};
import package::common::constants::PI;
import package::common::camera::camera;
import package::common::environment::environment;
import package::common::light::{HAS_AREA, LIGHT_AREA, lights, light_incidence};
import package::common::range::in_half_range;
import package::common::reflectance::{DIELECTRIC_F0, diffuse_albedo, lobe_reflectance, specular_f0};
import package::common::surface::{Surface, image_texel, surface_load};

struct Params {
    /// How far ambient occlusion darkens shadows and the diffuse gather, [0, 1] (RAU eq. 7.2, corrected).
    ao_weight: f32,
}

var<uniform> params: Params;
var image: texture_storage_2d_array<rgba16float, write>;
var shadow: texture_2d_array<f32>;
var ao: texture_2d_array<f32>;
var diffuse: texture_2d_array<f32>;
var specular: texture_2d_array<f32>;
var emission: texture_2d<f32>;

override HAS_SHADOW: bool = true;
override HAS_AO: bool = true;
override HAS_SPECULAR: bool = true;

fn direct_light(surface: Surface, pixel: vec2u, open: f32) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < environment.light_count; i++) {
        let light = lights[i];
        var visibility = open;
        if (HAS_SHADOW) {
            visibility *= textureLoad(shadow, image_texel(pixel, textureDimensions(shadow)), i / 4, 0)[i % 4];
        }
        let incidence = light_incidence(light, surface.position, surface.normal);
        var reflected = brdf(surface, incidence.direction);
        if (HAS_AREA && HAS_SPECULAR && light.kind == LIGHT_AREA) {
            // The specular image holds its mirror image.
            reflected = diffuse_brdf(surface, incidence.direction);
        }
        sum += reflected * incidence.irradiance * visibility;
    }
    return sum;
}

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let pixel = id.xy;
    if (any(pixel >= camera.screen)) {
        return;
    }
    let surface = surface_load(pixel);
    if (!surface.hit) {
        textureStore(image, pixel, 0, vec4f(in_half_range(environment.sky), 0.0));
        return;
    }
    var open = 1.0;
    if (HAS_AO) {
        // S·(1 + c·(O − 1)): c = 0 leaves the light alone, c = 1 multiplies it by the openness.
        open = 1.0 + params.ao_weight * (textureLoad(ao, image_texel(pixel, textureDimensions(ao)), 0, 0).r - 1.0);
    }
    let arriving = textureLoad(diffuse, image_texel(pixel, textureDimensions(diffuse)), 0, 0).rgb / PI * open;
    let lobe = lobe_reflectance(specular_f0(surface.base_color, surface.metallic), surface.roughness, saturate(dot(surface.normal, surface.view)));
    // Without a specular gather every lobe is wide: the cosine-weighted mean stands for it.
    var mirrored = arriving;
    if (HAS_SPECULAR) {
        mirrored = textureLoad(specular, image_texel(pixel, textureDimensions(specular)), 0, 0).rgb;
    }
    let dielectric_share = 1.0 - DIELECTRIC_F0;
    let radiance = textureLoad(emission, pixel, 0).rgb
        + direct_light(surface, pixel, open)
        + diffuse_albedo(surface.base_color, surface.metallic) * dielectric_share * arriving
        + lobe * mirrored;
    textureStore(image, pixel, 0, vec4f(in_half_range(radiance), 1.0));
}
