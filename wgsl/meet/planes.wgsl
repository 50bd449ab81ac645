// What a ray meets in an occupied cell: the planes of the cell's surfaces, as far as they lie in it.

import package::common::attributes::VoxelSurface;
import package::common::plane::{ALL_SQUARES, FRONT_HIGH, FRONT_LOW, SHOWS_HIGH, SHOWS_LOW, middle_of, plane_normal, square_at, unpack_plane};
import package::common::ray::{Passage, Ray, RayHit, Tangent};
import package::common::side::Side;
import package::common::trace::{Apex, voxel_apex};
import package::common::voxels::{is_occupied, voxel_slot};

var<storage, read> planes: array<vec2u>;

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
    var any_plane = false;
    for (var axis = 0u; axis < 3; axis++) {
        let words = planes[first + axis];
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
        let shown = (words.y & select(SHOWS_LOW, SHOWS_HIGH, towards < 0.0)) != 0;
        let behind = !shown && t < 1.0;
        if (of_left || of_goal || behind) {
            continue;
        }
        nearest = t;
        *hit = RayHit(true, t, cell, select(normal, -normal, towards > 0.0), shown);
    }
    if (!any_plane) {
        // Too little of a surface for a plane: all of the cell.
        *hit = RayHit(true, passage.enter, cell, passage.normal, true);
    }
    return nearest < ray.reach || !any_plane;
}

// Rays begin just over the surface.
fn leave(apex: Apex) -> Tangent {
    return Tangent(apex.position + (apex.depth + LIFT) * apex.normal, apex.normal);
}

// A surface run up to ends a ray just before it.
fn arrive(direction: vec3f, origin: vec3f, goal: Tangent) -> f32 {
    let cosine = max(-dot(goal.normal, direction), 1e-3);
    return (dot(origin - goal.point, goal.normal) - LIFT) / cosine;
}

// The fronts of a voxel's planes, each at the middle of what is there of it, by their areas.
fn side(cell: vec3u, slot: u32, surface: VoxelSurface, index: u32, turn: f32) -> Side {
    let centre = vec3f(cell) + 0.5;
    let axis = index / 2;
    let words = planes[3 * slot + axis];
    if (planes[3 * slot].y == 0 && planes[3 * slot + 1].y == 0 && planes[3 * slot + 2].y == 0) {
        return Side(voxel_apex(centre, surface.normal, turn), select(0.0, 1.0, index == 0), surface.double_sided);
    }
    let plane = unpack_plane(words);
    let up = plane_normal(plane, axis);
    let high = (index & 1) == 0;
    let normal = normalize(select(-up, up, high));
    let there = (words.y & select(FRONT_LOW, FRONT_HIGH, high)) != 0;
    let area = select(0.0, f32(countOneBits(words.y & ALL_SQUARES)) * length(up), there);
    let back = (words.y & select(SHOWS_HIGH, SHOWS_LOW, high)) != 0 && (words.y & select(FRONT_HIGH, FRONT_LOW, high)) == 0;
    return Side(Apex(centre + middle_of(plane, axis), normal, 0.0, turn), area, select(0.0, 1.0, back));
}
