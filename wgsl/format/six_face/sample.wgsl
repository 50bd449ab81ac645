// Six-face sampling: the three faces turned towards the observer. A ray crosses a cell's faces in proportion to
// |d|; the squares of RAU §5.2.2 and figure B.2 let a slanting ray through a closed wall.

import package::common::isotropic_base::{FACING_FULL, sample_over_base};
import package::common::seen_ahead::SeenAhead;
import package::common::volume::sample_block;
import package::format::faces::{FACES, face_of};
import package::format::options::{BASE, BASE_ISOTROPIC};

// Whether opacity from level 1 up is that of a surface's front only, so that a cone may reach back to the surface
// that it leaves.
const VOXEL_ONE_SIDED = true;

@group(2) @binding(1) var base: texture_3d<f32>;
@group(2) @binding(2) var faces: texture_3d<f32>;

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

// The same faces of cells beside: each axis' coordinate is moved to `beside`. Beyond the grid is nothing.
fn faces_beside(uvw: vec3f, beside: vec3f, size: vec3f, level: f32, direction: vec3f) -> mat3x4f {
    let f = faces_at(vec3f(beside.x, uvw.yz), vec3f(uvw.x, beside.y, uvw.z), vec3f(uvw.xy, beside.z), level, direction);
    let inside = saturate(0.5 + size * (0.5 - abs(beside - 0.5)));
    return mat3x4f(f[0] * inside.x, f[1] * inside.y, f[2] * inside.z);
}

// What of a face is known to lie ahead: all, or where it is `hidden` what cells ahead of the apex have of the same.
fn known_ahead(found: vec4f, ahead: vec4f, hidden: f32) -> vec4f {
    return mix(found, ahead * min(1.0, found.a / max(ahead.a, 1e-6)), hidden);
}

// A surface that faces −x is seen only from smaller x, so each axis is a case of its own. A linear filter 1.5 cells ahead
// of the apex finds no cell that it lies in, nor any behind. One cell behind it finds what coarser cells would take for
// what lies ahead, since theirs cover both.
fn sample_faces_ahead(uvw: vec3f, level: f32, direction: vec3f, apex: vec3f, before: vec3f) -> SeenAhead {
    // Cells along each side.
    let size = vec3f(textureDimensions(faces)) / (vec3f(1.0, 1.0, f32(FACES)) * exp2(ceil(level)));
    let cell = sign(direction) / size;
    let found = faces_at(uvw, uvw, uvw, level, direction);
    let back = faces_beside(uvw, apex - cell, size, level, direction);
    let behind = max(before, saturate(vec3f(back[0].a, back[1].a, back[2].a) / FACING_FULL));
    let hidden = select(vec3f(0.0), behind, (uvw - apex) * sign(direction) * size < vec3f(1.5));
    var known = found;
    if (any(hidden > vec3f(0.0))) {
        let ahead = faces_beside(uvw, apex + 1.5 * cell, size, level, direction);
        known[0] = known_ahead(found[0], ahead[0], hidden.x);
        known[1] = known_ahead(found[1], ahead[1], hidden.y);
        known[2] = known_ahead(found[2], ahead[2], hidden.z);
    }
    let seen = known * abs(direction);
    let opacity = dot(vec3f(found[0].a, found[1].a, found[2].a), abs(direction));
    let scale = 1.0 / max(opacity, 1.0);
    return SeenAhead(vec4f(seen.rgb, opacity) * scale, seen.a * scale, behind);
}

fn voxel_sample_ahead(uvw: vec3f, level: f32, direction: vec3f, apex: vec3f, behind: vec3f) -> SeenAhead {
    if (BASE != BASE_ISOTROPIC) {
        return sample_faces_ahead(uvw, level, direction, apex, behind);
    }
    let coarse = sample_faces_ahead(uvw, max(level - 1.0, 0.0), direction, apex, behind);
    if (level >= 1.0) {
        return coarse;
    }
    let value = sample_over_base(base, uvw, level, coarse.value);
    return SeenAhead(value, value.a - max(level, 0.0) * (coarse.value.a - coarse.known), coarse.behind);
}
