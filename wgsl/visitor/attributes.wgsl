// What is done with each voxel that a triangle overlaps: the triangle's reflectance, normal and emission are added to the voxel's
// slot, and the triangle is left where it is in front. Sums are fixed-point integers: the same bits whatever the order.

import package::common::clipped_area::clipped_area;
import package::common::conflict::{CONFLICT, CONFLICT_MAX, CONFLICT_SUM, average_reflectance, pack_reflectance};
import package::common::grid::grid;
import package::common::front::facet;
import package::common::fronts::add_front;
import package::common::fragment::{Corners, corners_of, fragment_at, fragment_normal};
import package::common::mesh::triangle_range;
import package::common::material::{Material, materials, base_color, emission, roughness_metallic, HAS_EMISSION};
import package::common::reflectance::total_reflectance;
import package::common::squares::remains;
import package::common::triangle_box::unswizzle;
import package::common::voxels::{is_occupied, voxel_slot};

var<storage, read_write> attributes: array<atomic<u32>>;

override ATTRIBUTE_STRIDE: u32 = 14;
override HAS_COVERAGE: bool = false;

struct Visitor {
    axis: u32,
    // Of all triangles.
    triangle: u32,
    corners: Corners,
    material: Material,
    // A triangle weighs as much as it can show of itself within one voxel, in voxel faces.
    weight: f32,
}

fn visitor(triangle: u32, v: array<vec3f, 3>, axis: u32) -> Visitor {
    let area = 0.5 * length(cross(v[1] - v[0], v[2] - v[0]));
    let corners = corners_of(triangle, v);
    return Visitor(axis, triangle_range.first + triangle, corners, materials[corners.material], clamp(area, 1.0 / 1024.0, 1.0));
}

fn add(word: u32, value: f32) {
    let units = u32(round(value * grid.attribute_scale));
    if (units != 0) {
        atomicAdd(&attributes[word], units);
    }
}

fn add_vector(first: u32, value: vec3f) {
    add(first, value.x);
    add(first + 1, value.y);
    add(first + 2, value.z);
}

fn add_reflectance(first: u32, reflectance: vec3f, weight: f32) {
    if (CONFLICT == CONFLICT_SUM) {
        add_vector(first, reflectance * weight);
    } else if (CONFLICT == CONFLICT_MAX) {
        atomicMax(&attributes[first], pack_reflectance(reflectance, 255));
    } else {
        var known = atomicLoad(&attributes[first]);
        loop {
            let swap = atomicCompareExchangeWeak(&attributes[first], known, average_reflectance(known, reflectance));
            if (swap.exchanged) {
                break;
            }
            known = swap.old_value;
        }
    }
}

fn add_fragment(visitor: Visitor, cell: vec3u) {
    // The two passes over the triangles may round differently at a voxel's edge: the bitmask decides.
    if (!is_occupied(cell, 0)) {
        return;
    }
    let f = fragment_at(visitor.corners, vec3f(cell) + 0.5);
    let material = visitor.material;
    let plane = facet(visitor.corners.v, visitor.axis, cell);
    let remains = remains(plane, visitor.corners, f, material);
    if (!remains.there) {
        return;
    }
    let color = base_color(material, f.uv, f.lod);
    let weight = visitor.weight;
    let shine = roughness_metallic(material, f.uv, f.lod);
    let slot = voxel_slot(cell);
    let reflectance = saturate(total_reflectance(color.rgb, shine.y, shine.x));
    let v = visitor.corners.v;
    let nearest = f.weights.x * v[0] + f.weights.y * v[1] + f.weights.z * v[2] - vec3f(cell) - 0.5;
    add_front(plane, visitor.axis, remains, material.double_sided != 0, nearest, visitor.triangle, slot);
    let first = slot * ATTRIBUTE_STRIDE;
    add(first, weight);
    add(first + 1, select(0.0, weight, material.double_sided != 0));
    add_reflectance(first + 2, reflectance, weight);
    // Positive and negative parts have words of their own.
    let n = fragment_normal(visitor.corners, f, material) * weight;
    let negative = select(vec3u(0), vec3u(3), n < vec3f(0.0));
    add(first + 5 + negative.x, abs(n.x));
    add(first + 6 + negative.y, abs(n.y));
    add(first + 7 + negative.z, abs(n.z));
    if (HAS_EMISSION) {
        let relative = emission(material, f.uv, f.lod) / grid.emission_max;
        add_vector(first + 11, clamp(relative, vec3f(0.0), vec3f(1.0)) * weight);
    }
    if (HAS_COVERAGE) {
        add(first + ATTRIBUTE_STRIDE - 1, remains.share * clipped_area(visitor.corners.v, cell));
    }
}

// Visits the voxel of a column, in swizzled cells; says which is next.
fn visit(visitor: ptr<function, Visitor>, cell: vec3i, top: i32) -> i32 {
    add_fragment(*visitor, unswizzle(vec3u(cell), (*visitor).axis));
    return cell.z + 1;
}

// Nothing is kept from voxel to voxel.
fn leave(visitor: Visitor) {}
