// glTF 2.0 appendix B: a dielectric reflects 4 % at normal incidence, a metal its base colour.

const DIELECTRIC_F0 = 0.04;

fn specular_f0(base_color: vec3f, metallic: f32) -> vec3f {
    return mix(vec3f(DIELECTRIC_F0), base_color, metallic);
}

fn diffuse_albedo(base_color: vec3f, metallic: f32) -> vec3f {
    return base_color * (1.0 - metallic);
}

// What a voxel reflects in all, as if it were Lambertian: the diffuse part and the specular part at
// normal incidence.
fn total_reflectance(base_color: vec3f, metallic: f32) -> vec3f {
    return diffuse_albedo(base_color, metallic) * (1.0 - DIELECTRIC_F0) + specular_f0(base_color, metallic);
}
