// glTF 2.0's metallic-roughness reflection (appendix B): GGX with height-correlated Smith shadowing and
// Schlick's Fresnel over a Lambertian base.

import package::common::constants::PI;
import package::common::range::unit_or;
import package::common::reflectance::{DIELECTRIC_F0, specular_f0, diffuse_albedo};
import package::common::surface::Surface;

// Of a mirror's lobe.
const LEAST_ALPHA = 1e-3;

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

// Reflectance of the GGX lobe under constant light: Karis, "Physically Based Shading on Mobile", 2014.
fn lobe_reflectance(surface: Surface) -> vec3f {
    let n_v = saturate(dot(surface.normal, surface.view));
    let r = surface.roughness * vec4f(-1.0, -0.0275, -0.572, 0.022) + vec4f(1.0, 0.0425, 1.04, -0.04);
    let a = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
    let scale_bias = vec2f(-1.04, 1.04) * a + r.zw;
    return specular_f0(surface.base_color, surface.metallic) * scale_bias.x + scale_bias.y;
}
