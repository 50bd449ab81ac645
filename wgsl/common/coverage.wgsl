// What a parent shows of its eight children, seen along an axis: the nearer child hides the farther, and the four
// columns average. Child i lies at (i & 1, i >> 1 & 1, i >> 2).

// Premultiplied radiance and opacity. The observer is on the side of the children whose coordinate along the axis is `near`.
fn composite_columns(children: array<vec4f, 8>, axis: u32, near: u32) -> vec4f {
    var seen = children;
    var sum = vec4f(0.0);
    for (var column = 0u; column < 4; column++) {
        // The column's bits but the axis' own.
        let below = column & ((1u << axis) - 1);
        let low = ((column - below) << 1) | below;
        let first = seen[low + (near << axis)];
        sum += first + (1.0 - first.a) * seen[low + ((1 - near) << axis)];
    }
    return sum / 4.0;
}

// The share of the parent that children of these opacities along x, y and z cover.
fn composite_coverage(opacity: array<vec3f, 8>) -> vec3f {
    var shares = opacity;
    var covered = vec3f(0.0);
    for (var axis = 0u; axis < 3; axis++) {
        var along: array<vec4f, 8>;
        for (var i = 0u; i < 8; i++) {
            along[i] = vec4f(shares[i][axis]);
        }
        covered[axis] = composite_columns(along, axis, 0).a;
    }
    return covered;
}
