// What the sides of a cell show to a cone that something lies behind. Along each axis what the near side shows more is of what lies
// ahead, but what both sides of the axes share may be of what lies behind.

import package::format::cell::{Cell, seen_along, share_of_axes, shared_in_all};

// How much of what another axis' near side shows more than its far one speaks for a wall seen from within; a factor: the
// most, in tenths, with which `stability`'s sealed boxes are dark. With 0.9 one lets in 0.0026 of what is outside.
const WITHIN = 0.7;

// Where something lies behind along other axes, their walls are taken to be as bright from outside as this axis' far side.
// A room is dark to both sides of an axis and its outside bright, if the cell holds both of the room's walls there; if it holds
// one, that is as bright to one side as the outside, to the other as the room.
fn shared_ahead(c: Cell, axis: u32, side: vec3f, hidden: vec3f) -> vec3f {
    let both = min(c.positive, c.negative);
    let far = select(c.negative, c.positive, side > vec3f(0.0))[axis];
    let outside = max(side[axis] * c.band1[axis], vec3f(0.0)) / max(far, 1e-3);
    var shared_of_all = shared_in_all(c);
    for (var i = 1u; i < 3; i++) {
        let other = (axis + i) % 3;
        let within = WITHIN * max(-side[other] * c.band1[other], vec3f(0.0));
        shared_of_all -= hidden[other] * max(outside * both[other] - within, vec3f(0.0));
    }
    return max(shared_of_all, vec3f(0.0)) * share_of_axes(c)[axis];
}

// Along one axis: premultiplied radiance and opacity of the side towards the cone.
fn side_ahead(c: Cell, axis: u32, side: vec3f, hidden: vec3f) -> vec4f {
    return seen_along(c, axis, side, shared_ahead(c, axis, side, hidden));
}
