// A ray through the voxels, and what it meets first. Lengths are voxels of level 0.

import package::common::trace::Apex;

// A surface that a ray leaves or runs up to: a point on it, and its unit normal. Without one the normal is zero.
struct Tangent {
    point: vec3f,
    normal: vec3f,
}

struct Ray {
    origin: vec3f,
    // Unit.
    direction: vec3f,
    // Along the direction; what lies farther is not met.
    reach: f32,
    // Surfaces that are not met: the one left, and the one run up to.
    left: Tangent,
    goal: Tangent,
}

struct RayHit {
    found: bool,
    // Along the ray.
    distance: f32,
    cell: vec3u,
    // Of the surface met, or of the cell's face, towards where the ray comes from; not unit.
    normal: vec3f,
    // The side met, in all voxels' sides (see common/side.wgsl), and whether the surface shows it.
    side: u32,
    shown: bool,
}

// Where a ray goes into and out of a cell, along it; `normal` is that of the face, towards where it comes from.
struct Passage {
    enter: f32,
    leave: f32,
    normal: vec3f,
}

// A ray and the box of all cells of a level.
struct Crossing {
    // In cells: where the ray begins, and how far it goes along each axis for each voxel of its length.
    origin: vec3f,
    slope: vec3f,
    inverse: vec3f,
    // Whether it goes towards larger coordinates.
    forwards: vec3<bool>,
    // Along the ray: where it enters the box, at least 0, and where it leaves it.
    enter: f32,
    leave: f32,
    // Of the face by which it enters, or against the ray where it begins within.
    normal: vec3f,
}

// `scale` is a cell's side in voxels. Where the ray misses the box, it leaves before it enters.
fn crossing_of(ray: Ray, size: vec3u, scale: f32) -> Crossing {
    var c: Crossing;
    // A finite slope for every axis: an axis-parallel ray never leaves sideways.
    c.slope = select(ray.direction, vec3f(1e-12), abs(ray.direction) < vec3f(1e-12)) / scale;
    c.origin = ray.origin / scale;
    c.inverse = 1.0 / c.slope;
    c.forwards = c.slope > vec3f(0.0);
    let to_low = -c.origin * c.inverse;
    let to_high = (vec3f(size) - c.origin) * c.inverse;
    let enters = min(to_low, to_high);
    let leaves = max(to_low, to_high);
    let enter = max(enters.x, max(enters.y, enters.z));
    c.enter = max(enter, 0.0);
    c.leave = min(leaves.x, min(leaves.y, leaves.z));
    c.normal = -ray.direction;
    if (enter > 0.0) {
        c.normal = select(vec3f(0.0), against(c), enters == vec3f(enter));
    }
    return c;
}

// Of faces by which the ray enters cells.
fn against(c: Crossing) -> vec3f {
    return select(vec3f(1.0), vec3f(-1.0), c.forwards);
}

fn ray_between(origin: vec3f, direction: vec3f, reach: f32) -> Ray {
    let none = Tangent(vec3f(0.0), vec3f(0.0));
    return Ray(origin, direction, reach, none, none);
}

// Planes so near to each other, and so parallel, are taken for one surface: voxels don't tell them apart.
const SAME_PLANE = 1.0;
const PARALLEL = 0.8;

// Whether the plane where normal · q = offset is that of a surface.
fn is_of(normal: vec3f, offset: f32, surface: Tangent) -> bool {
    let per_length = inverseSqrt(dot(normal, normal));
    let distance = (dot(normal, surface.point) - offset) * per_length;
    return abs(distance) < SAME_PLANE && abs(dot(normal, surface.normal)) * per_length > PARALLEL;
}

// How far over its surface a ray begins: more than rounding takes, less than anything that touches the surface.
const LIFT = 0.05;

// Rays begin just over the surface.
fn leave(apex: Apex) -> Tangent {
    return Tangent(apex.position + LIFT * apex.normal, apex.normal);
}

// A surface run up to ends a ray just before it.
fn arrive(direction: vec3f, origin: vec3f, goal: Tangent) -> f32 {
    let cosine = max(-dot(goal.normal, direction), 1e-3);
    return (dot(origin - goal.point, goal.normal) - LIFT) / cosine;
}
