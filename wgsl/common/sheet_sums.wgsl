// What triangles add up for a voxel's sheets: integers and bits, the same whatever the order.

import package::common::grid::grid;
import package::common::sheet::{ALL_SQUARES, AXIS_STRIDE, SHEET_STRIDE, SQUARES, TWO_SIDED};
import package::common::triangle_box::swizzle;

// For each axis of a voxel: weights of fronts towards + and −, their heights, two slopes, the bits, and what the fronts reflect. As
// pass/sheets.wgsl reads them.
var<storage, read_write> sheet_sums: array<atomic<u32>>;


// How far inside a triangle's edge from a to b a square lies with all of it; negative where some of it is outside. `facing`
// is positive where the corners turn from x to y.
fn inside_edge(a: vec2f, b: vec2f, facing: f32, centre: vec2f, half_side: f32) -> f32 {
    let along = b - a;
    let at = facing * (along.x * (centre.y - a.y) - along.y * (centre.x - a.x));
    return at - half_side * (abs(along.x) + abs(along.y));
}

fn is_inside(v: array<vec2f, 3>, facing: f32, centre: vec2f, half_side: f32) -> bool {
    return inside_edge(v[0], v[1], facing, centre, half_side) >= 0.0
        && inside_edge(v[1], v[2], facing, centre, half_side) >= 0.0
        && inside_edge(v[2], v[0], facing, centre, half_side) >= 0.0;
}

// The squares whose middles a triangle covers; corners relative to the voxel's centre, seen along the axis.
fn covered_squares(v: array<vec2f, 3>, facing: f32) -> u32 {
    if (is_inside(v, facing, vec2f(0.0), 0.5)) {
        return ALL_SQUARES;
    }
    var covered = 0u;
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        let middle = (vec2f(vec2u(i % SQUARES, i / SQUARES)) + 0.5) / f32(SQUARES) - 0.5;
        covered |= select(0u, 1u << i, is_inside(v, facing, middle, 0.0));
    }
    return covered;
}

// A triangle's plane in a voxel, and how much of it is there. Corners are voxels; the axis is the one that the normal is nearest to.
fn add_sheet(corners: array<vec3f, 3>, axis: u32, weight: f32, two_sided: bool, reflectance: vec3f, cell: vec3u, slot: u32) {
    let centre = vec3f(cell) + 0.5;
    let v = array(swizzle(corners[0] - centre, axis), swizzle(corners[1] - centre, axis), swizzle(corners[2] - centre, axis));
    let n = cross(v[1] - v[0], v[2] - v[1]);
    if (n.z == 0.0) {
        return;
    }
    let slope = clamp(-n.xy / n.z, vec2f(-1.0), vec2f(1.0));
    let height = clamp(v[0].z - dot(slope, v[0].xy), -1.5, 1.5);
    let first = slot * SHEET_STRIDE + AXIS_STRIDE * axis;
    let units = u32(round(weight * grid.attribute_scale));
    let sums = vec3u(round(f32(units) * vec3f(height / 3.0 + 0.5, 0.5 * slope + 0.5)));
    let low = select(1u, 0u, n.z > 0.0);
    atomicAdd(&sheet_sums[first + low], units);
    atomicAdd(&sheet_sums[first + 2 + low], sums.x);
    atomicAdd(&sheet_sums[first + 4], sums.y);
    atomicAdd(&sheet_sums[first + 5], sums.z);
    let reflected = vec3u(round(f32(units) * reflectance));
    atomicAdd(&sheet_sums[first + 7 + 3 * low], reflected.x);
    atomicAdd(&sheet_sums[first + 8 + 3 * low], reflected.y);
    atomicAdd(&sheet_sums[first + 9 + 3 * low], reflected.z);
    let squares = covered_squares(array(v[0].xy, v[1].xy, v[2].xy), n.z);
    atomicOr(&sheet_sums[first + 6], squares | select(0u, TWO_SIDED, two_sided));
}
