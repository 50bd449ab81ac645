// The voxelizer's unit of work: a triangle's columns in tiles of 8 x 8, so that a wall-sized triangle is
// many threads' job and a small one is a single thread's. `tile_ranks` is the number of tiles before each
// triangle, with the total at its end.

import package::common::frame::to_voxel;
import package::common::mesh::{vertices, triangle_indices};
import package::common::triangle_box::TriangleBox;

const TILE = 8;

fn triangle_voxel(triangle: u32) -> array<vec3f, 3> {
    let i = triangle_indices(triangle);
    return array(to_voxel(vertices[i.x].position), to_voxel(vertices[i.y].position), to_voxel(vertices[i.z].position));
}

fn tile_grid(b: TriangleBox) -> vec2u {
    if (any(b.cell_min > b.cell_max)) {
        return vec2u(0);
    }
    return vec2u((b.cell_max.xy - b.cell_min.xy) / TILE + 1);
}
