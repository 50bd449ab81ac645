// glTF 2.0 appendix B: a dielectric reflects 4 % at normal incidence, a metal its base colour.

const DIELECTRIC_F0 = 0.04;

fn specular_f0(base_color: vec3f, metallic: f32) -> vec3f {
    return mix(vec3f(DIELECTRIC_F0), base_color, metallic);
}

fn diffuse_albedo(base_color: vec3f, metallic: f32) -> vec3f {
    return base_color * (1.0 - metallic);
}

// Of a mirror's lobe.
const LEAST_ALPHA = 1e-3;

// 1, x, x², x³.
fn powers(x: f32) -> vec4f {
    return vec4f(1.0, x, x * x, x * x * x);
}

// How near to grazing a view is for a surface as rough as this: 0 along it, towards 1 above it.
fn steepness(n_v: f32, roughness: f32) -> f32 {
    let alpha = max(roughness * roughness, LEAST_ALPHA);
    return n_v * inverseSqrt(n_v * n_v + alpha * alpha);
}

// What the GGX lobe (common/brdf.wgsl) sends to one direction of constant light, and the same of one direction's light to all: ∫ f
// cosθ dω, by the direction's cosine with the normal. Its two parts are fits to the integral over all roughness from 0.03 and all
// directions, within 0.01. Straight above a surface of roughness 1 the first is 1 − ln 2.
fn lobe_reflectance(f0: vec3f, roughness: f32, n_v: f32) -> vec3f {
    let r = powers(roughness);
    let t = powers(steepness(n_v, roughness));
    // Of a mirror without colour.
    let whole = saturate(
        t.x * dot(r, vec4f(1.0981, -0.2286, 0.1926, -0.0929))
        + t.y * dot(r, vec4f(-1.0032, 0.0035, 2.9316, -4.3919))
        + t.z * dot(r, vec4f(1.7784, 8.2913, -23.9584, 18.6390))
        + t.w * dot(r, vec4f(-1.9962, -14.8303, 35.8378, -23.8094))
        + t.w * t.y * dot(r, vec4f(1.1334, 6.5101, -13.8626, 7.7781)));
    // Mean of Schlick's (1 − cosθ)⁵ over the lobe: as much of what F₀ leaves is reflected.
    let grazing = saturate(
        t.x * dot(r, vec4f(4.8270, -9.4036, 7.6288, -2.7360))
        + t.y * dot(r, vec4f(-10.6859, 24.9969, -26.7512, 11.4502))
        + t.z * dot(r, vec4f(5.8578, -15.5096, 18.8293, -8.3976))
        + pow(1.0 - n_v, 5.0)
            * (t.x * dot(r, vec4f(-3.6074, 5.5188, -3.0798, 0.8897))
                + t.y * dot(r, vec4f(10.5116, -22.8652, 8.2076, 3.8920))
                + t.z * dot(r, vec4f(-5.8857, 16.7940, -4.0418, -8.8963))));
    return whole * (f0 + (1.0 - f0) * grazing);
}

// What the GGX lobe reflects of even light to all sides together, for reflectances of 0 and 1 at normal incidence and Schlick's
// Fresnel: the mean over cosine-weighted directions of single scattering with height-correlated Smith shadowing, as
// polynomials of the perceptual roughness within 0.003 of it.
fn lobe_share(roughness: f32) -> vec2f {
    let r = roughness;
    let whole = 1.0 + r * (-0.0173 + r * (0.3521 + r * (-2.2374 + r * 1.3139)));
    let grazing = 0.0469 + r * (0.0426 + r * (-0.4189 + r * (0.5558 - r * 0.224)));
    return vec2f(grazing, whole);
}

// What passes the surface both ways, from all sides to all sides: 1 less the mean of Schlick's Fresnel for 0.04.
const TRANSMITTED = 0.9564;

// What a surface reflects of even light to all sides together: what a voxel, which has one value for all directions, reflects of
// what it gathers.
fn total_reflectance(base_color: vec3f, metallic: f32, roughness: f32) -> vec3f {
    let share = lobe_share(roughness);
    let lobe = mix(vec3f(share.x), vec3f(share.y), specular_f0(base_color, metallic));
    return TRANSMITTED * diffuse_albedo(base_color, metallic) + lobe;
}

// The same of light from one direction, by its cosine with the normal.
fn reflectance_from(base_color: vec3f, metallic: f32, roughness: f32, cosine: f32) -> vec3f {
    let lobe = lobe_reflectance(specular_f0(base_color, metallic), roughness, saturate(cosine));
    return TRANSMITTED * diffuse_albedo(base_color, metallic) + lobe;
}
