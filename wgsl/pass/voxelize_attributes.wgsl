// Adds each triangle's reflectance, normal and emission to the slots of the voxels that it overlaps.
// Sums are fixed-point integers: the same bits whatever the order.

import package::common::triangle_box::{triangle_box, column_range, column_cell_overlaps, unswizzle};
import package::common::tiles::triangle_voxel;
import package::common::tile_walk::{tile_ranks, tile_triangle, tile_columns};
import package::common::frame::frame;
import package::common::fragment::fragment_at;
import package::common::material::{materials, base_color, emission, roughness_metallic, HAS_ALPHA_MASK, HAS_EMISSION};
import package::common::mesh::{vertices, triangle_indices};
import package::common::octahedral::unpack_normal;
import package::common::voxels::{is_occupied, voxel_slot};
import package::common::reflectance::total_reflectance;
import package::common::dispatch::dispatch_index;

@group(1) @binding(4) var<storage, read_write> attributes: array<atomic<u32>>;

override ATTRIBUTE_STRIDE: u32 = 14;

fn add_vector(first: u32, value: vec3f) {
    let units = vec3u(round(value * frame.attribute_scale));
    atomicAdd(&attributes[first], units.x);
    atomicAdd(&attributes[first + 1], units.y);
    atomicAdd(&attributes[first + 2], units.z);
}

fn add_fragment(triangle: u32, v: array<vec3f, 3>, weight: f32, cell: vec3u) {
    // The two passes over the triangles may round differently at a voxel's edge: the bitmask decides.
    if (!is_occupied(cell, 0)) {
        return;
    }
    let f = fragment_at(triangle, v, vec3f(cell) + 0.5);
    let i = triangle_indices(triangle);
    let material = materials[vertices[i.x].material];
    let color = base_color(material, f.uv, f.lod);
    if (HAS_ALPHA_MASK && material.alpha_cutoff > 0.0 && color.a < material.alpha_cutoff) {
        return;
    }
    let normal = f.weights.x * unpack_normal(vertices[i.x].normal)
        + f.weights.y * unpack_normal(vertices[i.y].normal)
        + f.weights.z * unpack_normal(vertices[i.z].normal);
    let metallic = roughness_metallic(material, f.uv, f.lod).y;
    let n = normalize(normal + vec3f(0.0, 1e-20, 0.0)) * weight;
    let first = voxel_slot(cell) * ATTRIBUTE_STRIDE;
    let units = u32(round(weight * frame.attribute_scale));
    atomicAdd(&attributes[first], units);
    if (material.double_sided != 0) {
        atomicAdd(&attributes[first + 1], units);
    }
    add_vector(first + 2, clamp(total_reflectance(color.rgb, metallic), vec3f(0.0), vec3f(1.0)) * weight);
    add_vector(first + 5, max(n, vec3f(0.0)));
    add_vector(first + 8, max(-n, vec3f(0.0)));
    if (HAS_EMISSION) {
        let relative = emission(material, f.uv, f.lod) / frame.emission_max;
        add_vector(first + 11, clamp(relative, vec3f(0.0), vec3f(1.0)) * weight);
    }
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let tile = dispatch_index(id, 64);
    if (tile >= tile_ranks[frame.triangle_count]) {
        return;
    }
    let triangle = tile_triangle(tile);
    let v = triangle_voxel(triangle);
    let b = triangle_box(v);
    // A triangle weighs as much as it can show of itself within one voxel, in voxel faces.
    let area = 0.5 * length(cross(v[1] - v[0], v[2] - v[0]));
    let weight = clamp(area, 1.0 / 1024.0, 1.0);
    let columns = tile_columns(b, tile, triangle);
    for (var y = columns.first.y; y <= columns.last.y; y++) {
        for (var x = columns.first.x; x <= columns.last.x; x++) {
            let range = column_range(b, vec2i(x, y));
            for (var z = range.x; z <= range.y; z++) {
                if (column_cell_overlaps(b, vec3i(x, y, z))) {
                    add_fragment(triangle, v, weight, unswizzle(vec3u(vec3i(x, y, z)), b.axis));
                }
            }
        }
    }
}
