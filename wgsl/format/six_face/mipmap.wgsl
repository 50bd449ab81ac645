// Six-face mipmapping: along each axis the child nearer to the observer composites over the farther, then
// the four columns average (RAU §5.3.2, DVS §3). Level 1 parts an isotropic level 0 by the voxels' normals: a surface covers,
// and shows its light, at its front.

import package::common::attributes::voxel_surface;
import package::common::coverage::composite_columns;
import package::common::volume::{block_texel, load_volume};
import package::common::voxels::{is_occupied, voxel_slot};
import package::encoding::{VolumeTarget, encode_texel};
import package::format::faces::{FACES, face_of};
import package::format::options::{BASE, BASE_ISOTROPIC};

// Level 0, where it is the level below and isotropic; else the faces of the level below.
var base_source: texture_3d<f32>;
var faces_source: texture_3d<f32>;
var faces_target: VolumeTarget;

fn child(cell: vec3u, level: u32, axis: u32, side: u32) -> vec4f {
    if (level > 1 || BASE != BASE_ISOTROPIC) {
        let depth = textureDimensions(faces_source).z;
        return load_volume(faces_source, block_texel(cell, face_of(axis, side == 1), FACES, depth));
    }
    let value = load_volume(base_source, cell);
    if (value.a <= 0.0 || !is_occupied(cell, 0)) {
        return vec4f(0.0);
    }
    let surface = voxel_surface(voxel_slot(cell));
    return value * select(surface.front, surface.back, vec3<bool>(side == 1))[axis];
}

fn voxel_mipmap(cell: vec3u, level: u32) {
    let depth = textureDimensions(faces_target).z;
    for (var axis = 0u; axis < 3; axis++) {
        for (var side = 0u; side < 2; side++) {
            var children: array<vec4f, 8>;
            for (var i = 0u; i < 8; i++) {
                children[i] = child(cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2), level, axis, side);
            }
            let seen = composite_columns(children, axis, 1 - side);
            textureStore(faces_target, block_texel(cell, face_of(axis, side == 1), FACES, depth), encode_texel(seen));
        }
    }
}
