// The voxels of a level as cubes, seen by the camera: a ray for each pixel through the occupancy bitmask.

import package::common::camera::camera;
import package::common::grid::to_voxel;
import package::pass::shown_voxel::{ShownVoxel, params, CHANNEL_OCCUPANCY};
import package::common::step::step_params;
import package::common::ray::ray_between;
import package::common::surface::camera_ray;
import package::common::voxels::cell_rank;
import package::level_walk::first_hit_at;

var<storage, read> shown_voxels: array<ShownVoxel>;
var image: texture_storage_2d_array<rgba16float, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (any(id.xy >= camera.screen)) {
        return;
    }
    let level = step_params.level;
    let ray = normalize(camera_ray(id.xy));
    let hit = first_hit_at(ray_between(to_voxel(camera.eye), ray, 1e30), level);
    var value = vec4f(0.0);
    if (hit.found) {
        var color = shown_voxels[cell_rank(hit.cell, level)].color;
        if (params.channel == CHANNEL_OCCUPANCY) {
            color *= abs(dot(hit.normal, ray));
        }
        value = vec4f(color, 1.0);
    }
    textureStore(image, id.xy, 0, value);
}
