// glTF 2.0 appendix B: a dielectric reflects 4 % at normal incidence, a metal its base colour.

const DIELECTRIC_F0 = 0.04;

fn specular_f0(base_color: vec3f, metallic: f32) -> vec3f {
    return mix(vec3f(DIELECTRIC_F0), base_color, metallic);
}

fn diffuse_albedo(base_color: vec3f, metallic: f32) -> vec3f {
    return base_color * (1.0 - metallic);
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

// What a surface reflects of even light to all sides together: what a voxel, which has one value for all directions, reflects.
fn total_reflectance(base_color: vec3f, metallic: f32, roughness: f32) -> vec3f {
    let share = lobe_share(roughness);
    let lobe = mix(vec3f(share.x), vec3f(share.y), specular_f0(base_color, metallic));
    return TRANSMITTED * diffuse_albedo(base_color, metallic) + lobe;
}
