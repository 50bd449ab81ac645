// What a ray meets in an occupied cell: the whole cell.

import package::common::attributes::VoxelSurface;
import package::common::grid::cell_height;
import package::common::ray::{Passage, Ray, RayHit, Tangent};
import package::common::side::Side;
import package::common::trace::{Apex, voxel_apex};

fn meets(ray: Ray, cell: vec3u, passage: Passage, hit: ptr<function, RayHit>) -> bool {
    *hit = RayHit(true, passage.enter, cell, passage.normal, true);
    return true;
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

// One side, along the mean normal. Where opposite surfaces cancel, all six along the axes stand for a sixth of them each.
fn side(cell: vec3u, slot: u32, surface: VoxelSurface, index: u32, turn: f32) -> Side {
    let centre = vec3f(cell) + 0.5;
    if (all(surface.normal == vec3f(0.0))) {
        let axis = vec3f(vec3u(index / 2) == vec3u(0, 1, 2));
        return Side(voxel_apex(centre, select(axis, -axis, (index & 1) != 0), turn), 1.0, 0.0);
    }
    return Side(voxel_apex(centre, surface.normal, turn), select(0.0, 1.0, index == 0), surface.double_sided);
}
