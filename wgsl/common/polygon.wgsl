// Irradiance from a polygon of radiance 1: Lambert's formula, E = ½ Σ θᵢ (n · γᵢ), with the part below the
// horizon cut off (Baum, Rushmeier, Winget, "Improving Radiosity Solutions", SIGGRAPH 1989, eq. 5).

fn edge_integral(a: vec3f, b: vec3f, normal: vec3f) -> f32 {
    let perpendicular = cross(a, b);
    let sine = length(perpendicular);
    // As the edge's angle goes to zero, θ / sin θ goes to 1.
    let theta = atan2(sine, dot(a, b));
    return select(theta / sine, 1.0, sine < 1e-6) * dot(perpendicular, normal);
}

// Either side of the polygon counts.
fn polygon_irradiance(corners: array<vec3f, 4>, position: vec3f, normal: vec3f) -> f32 {
    var c = corners;
    var sum = 0.0;
    var entry = vec3f(0.0);
    var exit = vec3f(0.0);
    var crossings = 0;
    for (var i = 0; i < 4; i++) {
        let a = c[i] - position;
        let b = c[(i + 1) % 4] - position;
        let height_a = dot(a, normal);
        let height_b = dot(b, normal);
        if (height_a <= 0.0 && height_b <= 0.0) {
            continue;
        }
        var from_point = a;
        var to_point = b;
        if (height_a < 0.0) {
            from_point = mix(a, b, height_a / (height_a - height_b));
            entry = from_point;
            crossings++;
        }
        if (height_b < 0.0) {
            to_point = mix(a, b, height_a / (height_a - height_b));
            exit = to_point;
            crossings++;
        }
        let span = to_point - from_point;
        if (dot(span, span) > 0.0) {
            sum += edge_integral(normalize(from_point), normalize(to_point), normal);
        }
    }
    if (crossings == 2) {
        sum += edge_integral(normalize(exit), normalize(entry), normal);
    }
    return 0.5 * abs(sum);
}
