// How much of a voxel's face the part of a triangle within the voxel covers, seen along the triangle's dominant axis.

import package::common::triangle_box::{dominant_axis, swizzle};

// Points along a face's side at which it looks.
const POINTS = 8;

// Which side of the line from a to b a point is on.
fn side(a: vec2f, b: vec2f, p: vec2f) -> f32 {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

fn clipped_area(v: array<vec3f, 3>, cell: vec3u) -> f32 {
    let normal = cross(v[1] - v[0], v[2] - v[1]);
    let axis = dominant_axis(normal);
    let n = swizzle(normal, axis);
    let low = swizzle(vec3f(cell), axis);
    // Relative to the cell.
    let a = swizzle(v[0], axis) - low;
    let b = swizzle(v[1], axis) - low;
    let c = swizzle(v[2], axis) - low;
    let facing = sign(n.z);
    let slope = n.xy / n.z;
    var covered = 0;
    for (var y = 0; y < POINTS; y++) {
        for (var x = 0; x < POINTS; x++) {
            let p = (vec2f(vec2i(x, y)) + 0.5) / f32(POINTS);
            let depth = a.z - dot(slope, p - a.xy);
            let inside = min(facing * side(a.xy, b.xy, p), min(facing * side(b.xy, c.xy, p), facing * side(c.xy, a.xy, p)));
            covered += select(0, 1, inside >= 0.0 && depth >= 0.0 && depth < 1.0);
        }
    }
    return f32(covered) / f32(POINTS * POINTS);
}
