// A fragment a column (RAU §4.1.2): triangles drawn along their dominant axis onto a target as large as the grid's
// side, each widened so that every column that it overlaps has its centre inside (Hasselgren et al., GPU Gems 2, ch. 42).

import package::common::bands::{item_range, item_triangle, triangle_voxel};
import package::common::column_walk::visit_column;
import package::common::grid::grid;
import package::common::triangle_box::{EdgeBounds, TriangleBox, swizzle, triangle_box};
import package::visitor::visitor;

// Whether only triangles that were left are drawn, or all.
override DEFERRED: bool = true;

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) @interpolate(flat) cell_min: vec4i,
    @location(1) @interpolate(flat) cell_max: vec4i,
    @location(2) @interpolate(flat) plane: vec4f,
    @location(3) @interpolate(flat) x_by_y: vec3f,
    @location(4) @interpolate(flat) x_by_y_offset: vec3f,
    @location(5) @interpolate(flat) z_by_y: vec3f,
    @location(6) @interpolate(flat) z_by_y_offset: vec3f,
    @location(7) @interpolate(flat) z_by_x: vec3f,
    @location(8) @interpolate(flat) z_by_x_offset: vec3f,
    // Which bounds are lower ones, a bit each, by edge and then by coordinates as above.
    @location(9) @interpolate(flat) lower: vec3u,
    @location(10) @interpolate(flat) triangle: u32,
}

// How far the edges move, voxels: half a cell's diagonal, and what rounding may take.
const DILATION = 0.75;

// A corner of the triangle that holds all columns of the box.
fn box_corner(b: TriangleBox, corner: u32) -> vec2f {
    let low = vec2f(b.cell_min.xy);
    let extent = vec2f(b.cell_max.xy + 1) - low;
    return low - 1.0 + 2.0 * (extent + 2.0) * vec2f(vec2u(corner & 1, corner >> 1));
}

fn corner_position(b: TriangleBox, v: array<vec3f, 3>, corner: u32) -> vec2f {
    let p = array(swizzle(v[0], b.axis).xy, swizzle(v[1], b.axis).xy, swizzle(v[2], b.axis).xy);
    let here = p[corner];
    let before = normalize(here - p[(corner + 2) % 3]);
    let after = normalize(p[(corner + 1) % 3] - here);
    // Outwards along both edges; both edges move by DILATION where it is divided by the sine between them.
    let sine = abs(before.x * after.y - before.y * after.x);
    return here + (before - after) * (DILATION / sine);
}

// Whether moved edges meet near enough to be found exactly.
fn is_compact(b: TriangleBox, v: array<vec3f, 3>) -> bool {
    let extent = vec2f(b.cell_max.xy - b.cell_min.xy + 1);
    let low = vec2f(b.cell_min.xy) - extent - 4.0;
    let high = vec2f(b.cell_max.xy) + extent + 5.0;
    for (var i = 0u; i < 3; i++) {
        let p = corner_position(b, v, i);
        // False for what is not a number.
        if (!(all(p >= low) && all(p <= high))) {
            return false;
        }
    }
    return true;
}

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> Varyings {
    var triangle = index / 3;
    if (DEFERRED) {
        triangle = item_triangle(item_range().x + triangle);
    }
    let v = triangle_voxel(triangle);
    let b = triangle_box(v);
    var o: Varyings;
    if (any(b.cell_min > b.cell_max)) {
        // Beyond the view: nothing is drawn.
        o.clip = vec4f(2.0, 2.0, 0.0, 1.0);
        return o;
    }
    let corner = index % 3;
    let p = select(box_corner(b, corner), corner_position(b, v, corner), is_compact(b, v));
    let side = f32(max(grid.size.x, max(grid.size.y, grid.size.z)));
    o.clip = vec4f(p / side * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0), 0.0, 1.0);
    o.cell_min = vec4i(b.cell_min, i32(b.axis));
    o.cell_max = vec4i(b.cell_max, 0);
    o.plane = vec4f(b.slope, b.depth_lo, b.depth_hi);
    o.x_by_y = b.x_by_y.slope;
    o.x_by_y_offset = b.x_by_y.offset;
    o.z_by_y = b.z_by_y.slope;
    o.z_by_y_offset = b.z_by_y.offset;
    o.z_by_x = b.z_by_x.slope;
    o.z_by_x_offset = b.z_by_x.offset;
    o.lower = vec3u(b.x_by_y.lower) + 2 * vec3u(b.z_by_y.lower) + 4 * vec3u(b.z_by_x.lower);
    o.triangle = triangle;
    return o;
}

@fragment
fn fragment_main(o: Varyings) {
    let column = vec2i(floor(o.clip.xy));
    if (any(column < o.cell_min.xy) || any(column > o.cell_max.xy)) {
        return;
    }
    var b: TriangleBox;
    b.cell_min = o.cell_min.xyz;
    b.axis = u32(o.cell_min.w);
    b.cell_max = o.cell_max.xyz;
    b.slope = o.plane.xy;
    b.depth_lo = o.plane.z;
    b.depth_hi = o.plane.w;
    b.x_by_y = EdgeBounds(o.x_by_y, o.x_by_y_offset, (o.lower & vec3u(1)) != vec3u(0));
    b.z_by_y = EdgeBounds(o.z_by_y, o.z_by_y_offset, (o.lower & vec3u(2)) != vec3u(0));
    b.z_by_x = EdgeBounds(o.z_by_x, o.z_by_x_offset, (o.lower & vec3u(4)) != vec3u(0));
    visit_column(visitor(o.triangle, triangle_voxel(o.triangle), b.axis), b, column);
}
