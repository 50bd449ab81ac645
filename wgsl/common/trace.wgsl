// What every tracer is asked, and what it answers. Lengths are voxels of level 0.

// Where a trace starts: on a surface, whose own voxels it must leave.
struct Apex {
    position: vec3f,
    // Unit.
    normal: vec3f,
    // How far over the surface the trace begins: 1 is where the surface's own voxels end.
    start: f32,
}

// Where a trace ends.
struct Reach {
    // Along its direction.
    distance: f32,
    // A surface that the trace runs up to without meeting its voxels: a point and the unit normal. Without one the normal is zero.
    point: vec3f,
    normal: vec3f,
}

// What a trace met.
struct Gathered {
    // Premultiplied, W·m⁻²·sr⁻¹.
    radiance: vec3f,
    // [0, 1]
    opacity: f32,
    // To the first that it met; without any, the reach.
    distance: f32,
}

fn reach_of(distance: f32) -> Reach {
    return Reach(distance, vec3f(0.0), vec3f(0.0));
}

fn reach_up_to(point: vec3f, normal: vec3f) -> Reach {
    return Reach(1e30, point, normal);
}
