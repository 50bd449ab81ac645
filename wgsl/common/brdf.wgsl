// glTF 2.0's metallic-roughness reflection (appendix B): GGX with height-correlated Smith shadowing and
// Schlick's Fresnel over a Lambertian base.

import package::common::constants::PI;
import package::common::range::unit_or;
import package::common::reflectance::{DIELECTRIC_F0, LEAST_ALPHA, diffuse_albedo, powers, specular_f0, steepness};
import package::common::surface::Surface;

fn fresnel(f0: vec3f, cosine: f32) -> vec3f {
    return f0 + (1.0 - f0) * pow(1.0 - saturate(cosine), 5.0);
}

// What is reflected diffusely, over irradiance, from one direction.
fn diffuse_brdf(surface: Surface, light: vec3f) -> vec3f {
    let half_vector = unit_or(light + surface.view, surface.normal);
    let dielectric = fresnel(vec3f(DIELECTRIC_F0), dot(surface.view, half_vector));
    return (1.0 - dielectric) * diffuse_albedo(surface.base_color, surface.metallic) / PI;
}

// Of mirror directions about the normals that a viewer sees, for each unit of solid angle: G₁ D / (4 cosθ) (Heitz, "Sampling the GGX
// Distribution of Visible Normals", JCGT 7(4), 2018, eq. 17). All directions are unit.
fn mirror_density(normal: vec3f, view: vec3f, direction: vec3f, roughness: f32) -> f32 {
    let alpha = max(roughness * roughness, LEAST_ALPHA);
    let a2 = alpha * alpha;
    let half_vector = unit_or(view + direction, normal);
    let n_h = saturate(dot(normal, half_vector));
    let n_v = max(dot(normal, view), 1e-4);
    // With the half vector's sine, so that a narrow lobe keeps its digits.
    let across = cross(normal, half_vector);
    let spread = n_h * n_h * a2 + dot(across, across);
    return a2 / (PI * spread * spread) / (2.0 * (n_v + sqrt(a2 + (1.0 - a2) * n_v * n_v)));
}

// Outgoing radiance over irradiance, from one direction.
fn brdf(surface: Surface, light: vec3f) -> vec3f {
    let alpha = max(surface.roughness * surface.roughness, LEAST_ALPHA);
    let a2 = alpha * alpha;
    // A light exactly opposite to the view has none; nothing is reflected that way.
    let half_vector = unit_or(light + surface.view, surface.normal);
    let n_l = saturate(dot(surface.normal, light));
    let n_v = max(dot(surface.normal, surface.view), 1e-4);
    let n_h = saturate(dot(surface.normal, half_vector));
    let f = fresnel(specular_f0(surface.base_color, surface.metallic), dot(surface.view, half_vector));
    let denominator = n_h * n_h * (a2 - 1.0) + 1.0;
    let d = a2 / (PI * denominator * denominator);
    let v = 0.5 / max(n_l * sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * sqrt(n_l * n_l * (1.0 - a2) + a2), 1e-6);
    return diffuse_brdf(surface, light) + f * d * v;
}

// Share of the mirror directions about visible normals that lie above the surface: a fit to the integral over all roughness from
// 0.03 and all views, within 0.005.
fn share_above(n_v: f32, roughness: f32) -> f32 {
    let r = powers(roughness);
    let t = powers(steepness(n_v, roughness));
    return saturate(
        t.x * dot(r, vec4f(0.9000, 0.4397, -0.6599, 0.3240))
        + t.y * dot(r, vec4f(0.6841, -2.8768, 5.0447, -3.8439))
        + t.z * dot(r, vec4f(-1.4157, 4.7514, -7.9897, 5.4810))
        + t.w * dot(r, vec4f(0.8383, -2.4619, 4.3153, -3.3126)));
}
