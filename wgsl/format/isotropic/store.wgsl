// Isotropic: one premultiplied radiance and opacity a voxel, the same for every direction (RAU §5.1.1).

import package::common::volume::store_volume;
import package::encoding::VolumeTarget;

@group(2) @binding(8) var base_level0: VolumeTarget;

fn voxel_store(cell: vec3u, radiance: vec3f, normal: vec3f, opacity: f32) {
    store_volume(base_level0, cell, vec4f(radiance * opacity, opacity));
}
