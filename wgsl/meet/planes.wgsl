// What a ray meets in an occupied cell: the planes of the cell's surfaces, as far as they lie in it.

import package::common::plane::{plane_normal, square_at, unpack_plane};
import package::common::ray::{Passage, Ray, RayHit, Tangent};
import package::common::side::{SIDES, planes, side_shown};
import package::common::voxels::voxel_slot;

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
    let slot = voxel_slot(cell);
    let centre = vec3f(cell) + 0.5;
    let origin = ray.origin - centre;
    var nearest = ray.reach;
    var any_plane = false;
    for (var axis = 0u; axis < 3; axis++) {
        let words = planes[3 * slot + axis];
        if (words.y == 0) {
            continue;
        }
        any_plane = true;
        let plane = unpack_plane(words);
        let normal = plane_normal(plane, axis);
        let towards = dot(normal, ray.direction);
        let t = (plane.height - dot(normal, origin)) / towards;
        let at = origin + t * ray.direction;
        if (!(t > 0.0 && t < nearest) || any(abs(at) > vec3f(0.5 + OVERLAP)) || (words.y & square_at(at, axis)) == 0) {
            continue;
        }
        let of_left = t < NEAR && is_of(normal, centre, plane.height, ray.left);
        let of_goal = ray.reach - t < NEAR && is_of(normal, centre, plane.height, ray.goal);
        // Where a mean plane lies over the surface itself, a ray begins behind it, and leaves by its back.
        let met = 2 * axis + select(1u, 0u, towards < 0.0);
        let shown = side_shown(words.y, met);
        let behind = !shown && t < 1.0;
        if (of_left || of_goal || behind) {
            continue;
        }
        nearest = t;
        *hit = RayHit(true, t, cell, select(normal, -normal, towards > 0.0), SIDES * slot + met, shown);
    }
    if (!any_plane) {
        // Too little of a surface for a plane: all of the cell.
        *hit = RayHit(true, passage.enter, cell, passage.normal, SIDES * slot, true);
    }
    return nearest < ray.reach || !any_plane;
}
