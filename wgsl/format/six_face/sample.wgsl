// Six-face sampling: the three faces turned towards the observer. A ray crosses a cell's faces in proportion to
// |d|; the squares of RAU §5.2.2 and figure B.2 let a slanting ray through a closed wall.

import package::common::isotropic_base::sample_over_base;
import package::common::volume::sample_block;
import package::format::faces::{FACES, face_of};
import package::format::options::{BASE, BASE_ISOTROPIC};

// Whether opacity from level 1 up is that of a surface's front only, so that a cone may reach back to the surface
// that it leaves.
const VOXEL_ONE_SIDED = true;

@group(2) @binding(1) var base: texture_3d<f32>;
@group(2) @binding(2) var faces: texture_3d<f32>;

// `level` counts from the faces' first.
fn sample_faces(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let x = sample_block(faces, face_of(0, direction.x > 0.0), FACES, uvw, level);
    let y = sample_block(faces, face_of(1, direction.y > 0.0), FACES, uvw, level);
    let z = sample_block(faces, face_of(2, direction.z > 0.0), FACES, uvw, level);
    let value = abs(direction.x) * x + abs(direction.y) * y + abs(direction.z) * z;
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
