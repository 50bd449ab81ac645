// What a sample of the volume shows to a cone, which must not see what lies behind its apex: a coarse cell that the apex lies in
// reaches back through a wall, to whose outer side no cone from inside has a view. A surface that faces −x is seen only
// from smaller x, so each axis is a case of its own.

import package::common::isotropic_base::{FACING_FULL, sample_over_base};

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

// The directions along x, y and z in which a cone travels, 1 or −1.
fn ahead_along(direction: vec3f) -> vec3f {
    return select(vec3f(-1.0), vec3f(1.0), direction > vec3f(0.0));
}

// Places 1.5 cells ahead of the apex along each axis, or behind it where `side` is −1 times that: a linear filter finds there no
// cell that the apex lies in, nor any on its other side. `size` is in cells.
fn beside_apex(apex: vec3f, side: vec3f, size: vec3f) -> vec3f {
    return apex + 1.5 * side / size;
}

// Beyond the grid is nothing.
fn inside_grid(beside: vec3f, size: vec3f) -> vec3f {
    return saturate(0.5 + size * (0.5 - abs(beside - 0.5)));
}

// What lies behind the apex: what earlier samples found, and what this one does.
fn behind_apex(before: vec3f, opacity: vec3f) -> vec3f {
    return max(before, saturate(opacity / FACING_FULL));
}

// How far what lies behind hides each axis of a sample, which it does where the sample's cells may reach there.
fn hidden_axes(behind: vec3f, uvw: vec3f, apex: vec3f, side: vec3f, size: vec3f) -> vec3f {
    return select(vec3f(0.0), behind, (uvw - apex) * side * size < vec3f(1.5));
}

// `found` along each axis, of which known is all, or where it is hidden what cells `ahead` of the apex have of the same.
fn see_ahead(found: mat3x4f, ahead: mat3x4f, hidden: vec3f, behind: vec3f, direction: vec3f) -> SeenAhead {
    var known = vec4f(0.0);
    var opacity = 0.0;
    for (var axis = 0; axis < 3; axis++) {
        let same = ahead[axis] * min(1.0, found[axis].a / max(ahead[axis].a, 1e-6));
        known += mix(found[axis], same, hidden[axis]) * abs(direction[axis]);
        opacity += found[axis].a * abs(direction[axis]);
    }
    let scale = 1.0 / max(opacity, 1.0);
    return SeenAhead(vec4f(known.rgb, opacity) * scale, known.a * scale, behind);
}

// What a cone sees of levels of which only level 0, `base`, is the same from all sides, and known; `coarse` is from level 1 up.
fn see_over_base(base: texture_3d<f32>, uvw: vec3f, level: f32, coarse: SeenAhead) -> SeenAhead {
    if (level >= 1.0) {
        return coarse;
    }
    let value = sample_over_base(base, uvw, level, coarse.value);
    return SeenAhead(value, value.a - max(level, 0.0) * (coarse.value.a - coarse.known), coarse.behind);
}
