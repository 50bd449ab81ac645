// Which voxels a triangle overlaps: RAU §4.1, figures 4.4 (conservative, 26-separable) and 4.5 (thin,
// 6-separable). Coordinates are voxels, swizzled so that the normal's largest component is z: a column
// runs along z, its base is a cell of the plane of maximal projection.

import package::common::grid::grid;

override CONSERVATIVE: bool = true;

// The bounds that a projection's three edges set to one coordinate of a cell by another: slope·coordinate + offset, from
// below where `lower`, else from above.
struct EdgeBounds {
    slope: vec3f,
    offset: vec3f,
    lower: vec3<bool>,
}

struct TriangleBox {
    // Cells of the bounding box within the grid, inclusive; empty where any min > max.
    cell_min: vec3i,
    // Dominant axis of the normal: 0, 1, 2.
    axis: u32,
    cell_max: vec3i,
    // Projected along z, voxel².
    area: f32,
    // Depth range over a column's base: z in [lo, hi] - slope·base.
    slope: vec2f,
    depth_lo: f32,
    depth_hi: f32,
    // What x is in a row of columns, and z by y and by x.
    x_by_y: EdgeBounds,
    z_by_y: EdgeBounds,
    z_by_x: EdgeBounds,
}

fn swizzle(v: vec3f, axis: u32) -> vec3f {
    return select(select(v.xyz, v.zxy, vec3<bool>(axis == 1)), v.yzx, vec3<bool>(axis == 0));
}

fn swizzle_cell(v: vec3u, axis: u32) -> vec3u {
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

// Of an edge that is parallel to the bounded coordinate, voxels: so steep that it bounds all of it or nothing.
const PARALLEL = 1e-12;

// A cell (u, v) is on the inner side of an edge with normal n where n·(u, v) + c >= 0 (RAU figures 4.4 and 4.5), which
// bounds u by v. Corners are (u, v); `facing` is positive where they turn from u to v.
fn edge_bounds(u: vec3f, v: vec3f, facing: f32) -> EdgeBounds {
    let n_u = (v - v.yzx) * sign(facing);
    let n_v = (u.yzx - u) * sign(facing);
    var c = max(n_u, vec3f(0.0)) + max(n_v, vec3f(0.0));
    if (!CONSERVATIVE) {
        c = 0.5 * (n_u + n_v + max(abs(n_u), abs(n_v)));
    }
    let divisor = select(n_u, vec3f(PARALLEL), abs(n_u) < vec3f(PARALLEL));
    return EdgeBounds(-n_v / divisor, (n_u * u + n_v * v - c) / divisor, divisor > vec3f(0.0));
}

fn triangle_box(v: array<vec3f, 3>) -> TriangleBox {
    var b: TriangleBox;
    let normal_ws = cross(v[1] - v[0], v[2] - v[1]);
    b.axis = dominant_axis(normal_ws);
    let n = swizzle(normal_ws, b.axis);
    b.area = 0.5 * abs(n.z);
    let p = array(swizzle(v[0], b.axis), swizzle(v[1], b.axis), swizzle(v[2], b.axis));
    let grid_max = vec3i(swizzle(vec3f(grid.size), b.axis)) - 1;
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
    let x = vec3f(p[0].x, p[1].x, p[2].x);
    let y = vec3f(p[0].y, p[1].y, p[2].y);
    let z = vec3f(p[0].z, p[1].z, p[2].z);
    b.x_by_y = edge_bounds(x, y, n.z);
    b.z_by_y = edge_bounds(z, y, -n.x);
    b.z_by_x = edge_bounds(z, x, n.y);
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

// What of [x, y] is within all three edges at a coordinate; nothing where x > y.
fn bounded(edges: EdgeBounds, coordinate: f32, within: vec2f) -> vec2f {
    let at = edges.slope * coordinate + edges.offset;
    let low = select(vec3f(within.x), at, edges.lower);
    let high = select(at, vec3f(within.y), edges.lower);
    return vec2f(max(max(low.x, low.y), max(low.z, within.x)), min(min(high.x, high.y), min(high.z, within.y)));
}

// Cells between two bounds, inclusive; where there are none, these are still in integer range.
fn cells_within(bounds: vec2f) -> vec2i {
    return vec2i(clamp(vec2f(ceil(bounds.x), floor(bounds.y)), vec2f(-1e6), vec2f(1e6)));
}

// A row of columns: those that the triangle's projection overlaps, and between which depths; empty where x > y.
struct Row {
    columns: vec2i,
    depth: vec2f,
}

fn row_at(b: TriangleBox, y: i32) -> Row {
    let x = bounded(b.x_by_y, f32(y), vec2f(vec2i(b.cell_min.x, b.cell_max.x)));
    let z = bounded(b.z_by_y, f32(y), vec2f(vec2i(b.cell_min.z, b.cell_max.z)));
    return Row(cells_within(x), z);
}

// The cells of a column that the triangle overlaps, inclusive; empty where x > y.
fn column_range(b: TriangleBox, row: Row, base: vec2i) -> vec2i {
    let shift = dot(b.slope, vec2f(base));
    let z = bounded(b.z_by_x, f32(base.x), row.depth);
    return cells_within(vec2f(max(z.x, floor(b.depth_lo - shift)), min(z.y, floor(b.depth_hi - shift))));
}
