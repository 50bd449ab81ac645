// Six-face sampling: the three faces turned towards the observer. A ray crosses a cell's faces in proportion to
// |d|; the squares of RAU §5.2.2 and figure B.2 let a slanting ray through a closed wall.

import package::common::isotropic_base::sample_over_base;
import package::common::seen_ahead::{SeenAhead, ahead_along, behind_apex, beside_apex, hidden_axes, inside_grid, see_ahead, see_over_base};
import package::common::volume::sample_block;
import package::format::faces::{FACES, face_of};
import package::format::options::{BASE, BASE_ISOTROPIC};

// Whether opacity from level 1 up is that of a surface's front only, so that a cone may reach back to the surface
// that it leaves.
const VOXEL_ONE_SIDED = true;

var base: texture_3d<f32>;
var faces: texture_3d<f32>;

// What the faces towards the observer show, each at its own place. `level` counts from the faces' first, here and below.
fn faces_at(x: vec3f, y: vec3f, z: vec3f, level: f32, direction: vec3f) -> mat3x4f {
    return mat3x4f(
        sample_block(faces, face_of(0, direction.x > 0.0), FACES, x, level),
        sample_block(faces, face_of(1, direction.y > 0.0), FACES, y, level),
        sample_block(faces, face_of(2, direction.z > 0.0), FACES, z, level),
    );
}

fn sample_faces(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let value = faces_at(uvw, uvw, uvw, level, direction) * abs(direction);
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

// The same faces beside: each axis' coordinate is moved to `beside`.
fn faces_beside(uvw: vec3f, beside: vec3f, size: vec3f, level: f32, direction: vec3f) -> mat3x4f {
    let f = faces_at(vec3f(beside.x, uvw.yz), vec3f(uvw.x, beside.y, uvw.z), vec3f(uvw.xy, beside.z), level, direction);
    let inside = inside_grid(beside, size);
    return mat3x4f(f[0] * inside.x, f[1] * inside.y, f[2] * inside.z);
}

fn see_faces_ahead(uvw: vec3f, level: f32, direction: vec3f, apex: vec3f, before: vec3f) -> SeenAhead {
    let side = ahead_along(direction);
    // Cells along each side.
    let size = vec3f(textureDimensions(faces)) / (vec3f(1.0, 1.0, f32(FACES)) * exp2(ceil(level)));
    let found = faces_at(uvw, uvw, uvw, level, direction);
    let back = faces_beside(uvw, beside_apex(apex, -side, size), size, level, direction);
    let behind = behind_apex(before, vec3f(back[0].a, back[1].a, back[2].a));
    let hidden = hidden_axes(behind, uvw, apex, side, size);
    var ahead = found;
    if (any(hidden > vec3f(0.0))) {
        ahead = faces_beside(uvw, beside_apex(apex, side, size), size, level, direction);
    }
    return see_ahead(found, ahead, hidden, behind, direction);
}

fn voxel_sample_ahead(uvw: vec3f, level: f32, direction: vec3f, apex: vec3f, behind: vec3f) -> SeenAhead {
    if (BASE != BASE_ISOTROPIC) {
        return see_faces_ahead(uvw, level, direction, apex, behind);
    }
    return see_over_base(base, uvw, level, see_faces_ahead(uvw, max(level - 1.0, 0.0), direction, apex, behind));
}
