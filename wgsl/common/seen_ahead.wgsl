// What a sample of the volume shows to a cone, which must not see what lies behind its apex: a coarse cell that the apex lies in
// reaches back through a wall, to whose outer side no cone from inside has a view.

struct SeenAhead {
    // Premultiplied radiance of what is known to lie ahead, and opacity of all that is found.
    value: vec4f,
    // Opacity of that which the radiance is of; the rest's is unknown.
    known: f32,
    // For the cone's next sample: how opaque is what faces the cone behind its apex, along each axis, [0, 1].
    behind: vec3f,
}

// Of a format that can't tell: all lies ahead.
fn all_ahead(value: vec4f) -> SeenAhead {
    return SeenAhead(value, value.a, vec3f(0.0));
}
