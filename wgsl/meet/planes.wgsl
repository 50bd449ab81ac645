// What a ray meets in an occupied cell: the planes of the cell's surfaces, as far as they lie in it.

import package::common::grid::to_voxel;
import package::common::plane::{plane_normal, unpack_plane};
import package::common::ray::{Passage, Ray, RayHit, Tangent};
import package::common::trace::Apex;
import package::common::voxels::{is_occupied, voxel_slot};

var<storage, read> planes: array<u32>;

// How far over its surface a ray begins: more than rounding takes, less than anything that touches the surface.
const LIFT = 0.05;
// How far out of its cell a plane is still met, so that planes of neighbours leave no gap between them.
const OVERLAP = 0.1;
// A surface is the one that a ray leaves where its plane is so near to where the ray begins, and so parallel.
const SAME_PLANE = 1.0;
const PARALLEL = 0.8;
// And only so far from the apex.
const NEAR = 3.0;

// Whether a plane is that of a surface that the ray leaves or runs up to.
fn is_of(normal: vec3f, centre: vec3f, height: f32, surface: Tangent) -> bool {
    let per_length = inverseSqrt(dot(normal, normal));
    let distance = dot(normal, surface.point - centre) - height;
    return abs(distance) * per_length < SAME_PLANE && abs(dot(normal, surface.normal)) * per_length > PARALLEL;
}

fn meets(ray: Ray, cell: vec3u, passage: Passage, hit: ptr<function, RayHit>) -> bool {
    let first = 3 * voxel_slot(cell);
    let centre = vec3f(cell) + 0.5;
    let origin = ray.origin - centre;
    var nearest = ray.reach;
    var words = vec3u(planes[first], planes[first + 1], planes[first + 2]);
    if (all(words == vec3u(0))) {
        // Too little of a surface for a plane: all of the cell.
        *hit = RayHit(true, passage.enter, cell, passage.normal, true);
        return true;
    }
    for (var axis = 0u; axis < 3; axis++) {
        let word = words[axis];
        if (word == 0) {
            continue;
        }
        let plane = unpack_plane(word);
        let normal = plane_normal(plane, axis);
        let towards = dot(normal, ray.direction);
        let t = (plane.height - dot(normal, origin)) / towards;
        if (!(t > 0.0 && t < nearest) || any(abs(origin + t * ray.direction) > vec3f(0.5 + OVERLAP))) {
            continue;
        }
        let of_left = t < NEAR && is_of(normal, centre, plane.height, ray.left);
        let of_goal = ray.reach - t < NEAR && is_of(normal, centre, plane.height, ray.goal);
        // Where a mean plane lies over the surface itself, a ray begins behind it, and leaves by its back.
        let shown = select(plane.shown.y, plane.shown.x, towards < 0.0);
        let behind = !shown && t < 1.0;
        if (of_left || of_goal || behind) {
            continue;
        }
        nearest = t;
        *hit = RayHit(true, t, cell, select(normal, -normal, towards > 0.0), shown);
    }
    return nearest < ray.reach;
}

// Rays begin just over the surface. An apex in the middle of a voxel is first moved before all the planes of the voxel that
// look its way.
fn leave(apex: Apex) -> Tangent {
    var point = apex.position;
    if (apex.depth > 0.0) {
        let cell = vec3u(point);
        let centre = vec3f(cell) + 0.5;
        let first = 3 * voxel_slot(cell);
        for (var axis = 0u; axis < 3; axis++) {
            let word = planes[first + axis];
            let plane = unpack_plane(word);
            let up = plane_normal(plane, axis);
            let facing = dot(up, apex.normal);
            let shown = select(plane.shown.y, plane.shown.x, facing > 0.0);
            let over = (dot(up, point - centre) - plane.height) * sign(facing);
            // One plane that looks along the normal, or several that look aslant.
            if (word != 0 && shown && abs(facing) > 0.3 && (abs(facing) > 0.9 || over < 0.0)) {
                point -= up * (sign(facing) * over / dot(up, up));
            }
        }
    }
    return Tangent(point + LIFT * apex.normal, apex.normal);
}

// A surface run up to ends a ray just before it.
fn arrive(direction: vec3f, origin: vec3f, goal: Tangent) -> f32 {
    let cosine = max(-dot(goal.normal, direction), 1e-3);
    return (dot(origin - goal.point, goal.normal) - LIFT) / cosine;
}
