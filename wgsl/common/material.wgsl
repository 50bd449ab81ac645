// glTF metallic-roughness materials. Textures are layers of two arrays, colour (sRGB) and data (linear).

struct Material {
    base_color: vec4f,
    emission: vec3f,
    // 0: no mask.
    alpha_cutoff: f32,
    metallic: f32,
    roughness: f32,
    normal_scale: f32,
    double_sided: u32,
    // Layers; negative: no texture.
    base_color_layer: i32,
    metallic_roughness_layer: i32,
    normal_layer: i32,
    emission_layer: i32,
}

var<storage, read> materials: array<Material>;
var color_textures: texture_2d_array<f32>;
var data_textures: texture_2d_array<f32>;
var material_sampler: sampler;

// Left out of a pipeline whose scene has no such material.
override HAS_TEXTURES: bool = true;
override HAS_ALPHA_MASK: bool = true;
override HAS_EMISSION: bool = true;
// Texels along a side of a texture layer.
override TEXTURE_SIZE: f32 = 1024.0;

fn base_color(material: Material, uv: vec2f, lod: f32) -> vec4f {
    if (HAS_TEXTURES && material.base_color_layer >= 0) {
        return material.base_color * textureSampleLevel(color_textures, material_sampler, uv, material.base_color_layer, lod);
    }
    return material.base_color;
}

fn emission(material: Material, uv: vec2f, lod: f32) -> vec3f {
    if (HAS_TEXTURES && material.emission_layer >= 0) {
        return material.emission * textureSampleLevel(color_textures, material_sampler, uv, material.emission_layer, lod).rgb;
    }
    return material.emission;
}

// x: roughness, y: metallic.
fn roughness_metallic(material: Material, uv: vec2f, lod: f32) -> vec2f {
    let factor = vec2f(material.roughness, material.metallic);
    if (HAS_TEXTURES && material.metallic_roughness_layer >= 0) {
        return factor * textureSampleLevel(data_textures, material_sampler, uv, material.metallic_roughness_layer, lod).gb;
    }
    return factor;
}

fn shading_normal(material: Material, uv: vec2f, lod: f32, normal: vec3f, tangent: vec4f) -> vec3f {
    if (!HAS_TEXTURES || material.normal_layer < 0) {
        return normal;
    }
    let texel = textureSampleLevel(data_textures, material_sampler, uv, material.normal_layer, lod).xyz * 2.0 - 1.0;
    let t = tangent.xyz - normal * dot(normal, tangent.xyz);
    let b = cross(normal, t) * tangent.w;
    let n = t * texel.x * material.normal_scale + b * texel.y * material.normal_scale + normal * texel.z;
    let length_squared = dot(n, n);
    return select(normal, n * inverseSqrt(length_squared), length_squared > 1e-12);
}
