// The share of a parent that its eight children cover, seen along x, y and z: along each axis the nearer child
// hides the farther, and the four columns average. Child i lies at (i & 1, i >> 1 & 1, i >> 2).

fn composite_coverage(opacity: array<vec3f, 8>) -> vec3f {
    var o = opacity;
    var covered = vec3f(0.0);
    for (var column = 0u; column < 4; column++) {
        let low = column & 1;
        let high = column >> 1;
        // The two children of a column along each axis.
        let x = vec2f(o[2 * column].x, o[2 * column + 1].x);
        let y = vec2f(o[low + 4 * high].y, o[low + 4 * high + 2].y);
        let z = vec2f(o[column].z, o[column + 4].z);
        covered += vec3f(x.x + (1.0 - x.x) * x.y, y.x + (1.0 - y.x) * y.y, z.x + (1.0 - z.x) * z.y);
    }
    return covered / 4.0;
}
