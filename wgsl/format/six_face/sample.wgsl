// Six-face sampling: the three faces turned towards the observer. A ray crosses a cell's faces in proportion to
// |d|; the squares of RAU §5.2.2 and figure B.2 let a slanting ray through a closed wall.

import package::common::isotropic_base::sample_over_base;
import package::common::volume::sample_block;
import package::format::faces::{FACES, face_of};
import package::format::options::{BASE, BASE_ISOTROPIC};

var base: texture_3d<f32>;
var faces: texture_3d<f32>;

fn face_towards(axis: u32, uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    return sample_block(faces, face_of(axis, direction[axis] > 0.0), FACES, uvw, level);
}

// `level` counts from the faces' first.
fn sample_faces(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let share = abs(direction);
    let value = share.x * face_towards(0, uvw, level, direction)
        + share.y * face_towards(1, uvw, level, direction)
        + share.z * face_towards(2, uvw, level, direction);
    return value / max(value.a, 1.0);
}

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    if (BASE != BASE_ISOTROPIC) {
        return sample_faces(uvw, level, direction);
    }
    let coarse = sample_faces(uvw, max(level - 1.0, 0.0), direction);
    if (level >= 1.0) {
        return coarse;
    }
    return sample_over_base(base, uvw, level, coarse);
}
