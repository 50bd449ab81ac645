// What the camera sees: four targets and depth, one draw for the whole scene.

import package::common::camera::camera;
import package::common::material::{materials, base_color, emission, roughness_metallic, shading_normal, HAS_ALPHA_MASK, TEXTURE_SIZE};
import package::common::mesh::vertices;
import package::common::octahedral::{unpack_normal, unpack_tangent};
import package::common::range::{in_half_range, unit_or};

// Textures as the mean over a pixel, or else at its middle.
override FILTERS_TEXTURES: bool = true;

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) tangent: vec4f,
    @location(3) uv: vec2f,
    @location(4) @interpolate(flat) material: u32,
}

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> Varyings {
    let v = vertices[index];
    var o: Varyings;
    o.clip = camera.view_projection * vec4f(v.position, 1.0);
    o.position = v.position;
    o.normal = unpack_normal(v.normal);
    o.tangent = unpack_tangent(v.tangent);
    o.uv = v.uv;
    o.material = v.material;
    return o;
}

struct Targets {
    // Base colour; metallic in alpha.
    @location(0) albedo: vec4f,
    // Shading normal; roughness.
    @location(1) normal: vec4f,
    // The triangle's normal; 1.
    @location(2) geometry: vec4f,
    // W·m⁻²·sr⁻¹
    @location(3) emission: vec4f,
}

@fragment
fn fragment_main(v: Varyings, @builtin(front_facing) front: bool) -> Targets {
    let material = materials[v.material];
    if (!front && material.double_sided == 0) {
        discard;
    }
    let texel_x = dpdx(v.uv) * TEXTURE_SIZE;
    let texel_y = dpdy(v.uv) * TEXTURE_SIZE;
    let lod = select(0.0, 0.5, FILTERS_TEXTURES) * log2(max(max(dot(texel_x, texel_x), dot(texel_y, texel_y)), 1e-8));
    let color = base_color(material, v.uv, lod);
    if (HAS_ALPHA_MASK && color.a < material.alpha_cutoff) {
        discard;
    }
    let facing = select(-1.0, 1.0, front);
    // In voxels, so that neither tiny nor huge scenes leave the range of squares.
    let flat = unit_or(cross(dpdy(v.position) / camera.voxel_size, dpdx(v.position) / camera.voxel_size), v.normal);
    let interpolated = unit_or(v.normal, flat * facing);
    let surface = roughness_metallic(material, v.uv, lod);
    var o: Targets;
    o.albedo = vec4f(color.rgb, surface.y);
    // Derivatives give the plane; the camera's side gives the sign.
    let towards = flat * select(-1.0, 1.0, dot(flat, camera.eye - v.position) > 0.0);
    o.geometry = vec4f(towards, 1.0);
    // From behind, the surface is turned round with what its map shows. The front is that of the triangle's winding, also where a
    // file's normals point to the other side.
    let shading = shading_normal(material, v.uv, lod, interpolated, v.tangent) * facing;
    o.normal = vec4f(select(shading, -shading, dot(shading, towards) < 0.0), surface.x);
    // Only the front emits, unless both sides are shaded.
    o.emission = vec4f(in_half_range(emission(material, v.uv, lod)), 1.0);
    return o;
}
