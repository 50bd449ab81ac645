// Which voxels a triangle overlaps: RAU §4.1, figures 4.4 (conservative, 26-separable) and 4.5 (thin,
// 6-separable). Coordinates are voxels, swizzled so that the normal's largest component is z: a column
// runs along z, its base is a cell of the plane of maximal projection.

import package::common::frame::frame;

override CONSERVATIVE: bool = true;

struct TriangleBox {
    // Cells of the bounding box within the grid, inclusive; empty where any min > max.
    cell_min: vec3i,
    // Dominant axis of the normal: 0, 1, 2.
    axis: u32,
    cell_max: vec3i,
    // Depth range over a column's base: z in [lo, hi] - slope·base.
    depth_lo: f32,
    slope: vec2f,
    depth_hi: f32,
    // Projected along z, voxel².
    area: f32,
    // A base cell b, or a side cell, is inside the edge's projection where dot(edge.xy, b) + edge.z >= 0.
    edges_xy: array<vec3f, 3>,
    edges_yz: array<vec3f, 3>,
    edges_zx: array<vec3f, 3>,
}

fn swizzle(v: vec3f, axis: u32) -> vec3f {
    return select(select(v.xyz, v.zxy, vec3<bool>(axis == 1)), v.yzx, vec3<bool>(axis == 0));
}

fn unswizzle(v: vec3u, axis: u32) -> vec3u {
    return select(select(v.xyz, v.yzx, vec3<bool>(axis == 1)), v.zxy, vec3<bool>(axis == 0));
}

// Of a normal: 0, 1, 2.
fn dominant_axis(normal: vec3f) -> u32 {
    let size = abs(normal);
    return select(select(2u, 1u, size.y > size.z), 0u, size.x >= size.y && size.x >= size.z);
}

fn edge_test(edge: vec2f, vertex: vec2f, facing: f32) -> vec3f {
    let n = vec2f(-edge.y, edge.x) * sign(facing);
    if (CONSERVATIVE) {
        return vec3f(n, max(0.0, n.x) + max(0.0, n.y) - dot(n, vertex));
    }
    return vec3f(n, dot(n, 0.5 - vertex) + 0.5 * max(abs(n.x), abs(n.y)));
}

fn triangle_box(v: array<vec3f, 3>) -> TriangleBox {
    var b: TriangleBox;
    let normal_ws = cross(v[1] - v[0], v[2] - v[1]);
    b.axis = dominant_axis(normal_ws);
    let n = swizzle(normal_ws, b.axis);
    b.area = 0.5 * abs(n.z);
    let p = array(swizzle(v[0], b.axis), swizzle(v[1], b.axis), swizzle(v[2], b.axis));
    let grid_max = vec3i(swizzle(vec3f(frame.grid_size), b.axis)) - 1;
    let lowest = min(p[0], min(p[1], p[2]));
    let highest = max(p[0], max(p[1], p[2]));
    // Clamped before the conversion, so that far-off triangles stay in integer range.
    let limit = vec3f(grid_max) + 2.0;
    b.cell_min = max(vec3i(floor(clamp(lowest, vec3f(-2.0), limit))), vec3i(0));
    b.cell_max = min(vec3i(floor(clamp(highest, vec3f(-2.0), limit))), grid_max);
    // A triangle without area covers nothing.
    if (!(abs(n.z) > 0.0)) {
        b.cell_max = vec3i(-1);
        return b;
    }
    for (var i = 0; i < 3; i++) {
        let e = p[(i + 1) % 3] - p[i];
        b.edges_xy[i] = edge_test(e.xy, p[i].xy, n.z);
        b.edges_yz[i] = edge_test(e.yz, p[i].yz, n.x);
        b.edges_zx[i] = edge_test(e.zx, p[i].zx, n.y);
    }
    b.slope = n.xy / n.z;
    let depth = p[0].z + dot(b.slope, p[0].xy);
    if (CONSERVATIVE) {
        b.depth_lo = depth - max(0.0, b.slope.x) - max(0.0, b.slope.y);
        b.depth_hi = depth - min(0.0, b.slope.x) - min(0.0, b.slope.y);
    } else {
        b.depth_lo = depth - 0.5 * (b.slope.x + b.slope.y);
        b.depth_hi = b.depth_lo;
    }
    return b;
}

fn inside(edges: array<vec3f, 3>, cell: vec2f) -> bool {
    return dot(edges[0].xy, cell) + edges[0].z >= 0.0
        && dot(edges[1].xy, cell) + edges[1].z >= 0.0
        && dot(edges[2].xy, cell) + edges[2].z >= 0.0;
}

// The cells along a column that may overlap, inclusive; empty where x > y.
fn column_range(b: TriangleBox, base: vec2i) -> vec2i {
    if (!inside(b.edges_xy, vec2f(base))) {
        return vec2i(0, -1);
    }
    let shift = dot(b.slope, vec2f(base));
    return vec2i(max(i32(floor(b.depth_lo - shift)), b.cell_min.z), min(i32(floor(b.depth_hi - shift)), b.cell_max.z));
}

fn column_cell_overlaps(b: TriangleBox, cell: vec3i) -> bool {
    return inside(b.edges_yz, vec2f(cell.yz)) && inside(b.edges_zx, vec2f(cell.zx));
}
