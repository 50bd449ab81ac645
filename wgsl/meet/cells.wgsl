// What a ray meets in an occupied cell: the whole cell.

import package::common::ray::{Passage, Ray, RayHit, Tangent};
import package::common::trace::Apex;

fn meets(ray: Ray, cell: vec3u, passage: Passage, hit: ptr<function, RayHit>) -> bool {
    *hit = RayHit(true, passage.enter, cell, passage.normal, true);
    return true;
}

// How far over a plane of this normal the cells that it touches reach, in voxels.
fn cell_height(normal: vec3f) -> f32 {
    return abs(normal.x) + abs(normal.y) + abs(normal.z);
}

// Rays begin where the surface's own cells end.
fn leave(apex: Apex) -> Tangent {
    return Tangent(apex.position + apex.normal * (apex.depth + cell_height(apex.normal)), apex.normal);
}

// A surface run up to ends a ray where its cells begin.
fn arrive(direction: vec3f, origin: vec3f, goal: Tangent) -> f32 {
    let cosine = max(-dot(goal.normal, direction), 1e-3);
    return (dot(origin - goal.point, goal.normal) - cell_height(goal.normal)) / cosine;
}
