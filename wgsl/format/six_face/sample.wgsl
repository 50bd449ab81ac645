// Six-face sampling: the three faces turned towards the observer, weighted by the squares of the
// direction's components (RAU §5.2.2 and figure B.2).

import package::common::frame::frame;
import package::common::volume_sampler::volume_sampler;
import package::format::faces::{FACES, face_of};

// Whether opacity from level 1 up is that of a surface's front only, so that a cone may reach back to the surface
// that it leaves.
const VOXEL_ONE_SIDED = true;

@group(2) @binding(1) var base: texture_3d<f32>;
@group(2) @binding(2) var faces: texture_3d<f32>;

fn sample_face(face: u32, uvw: vec3f, level: f32, half_texel: f32) -> vec4f {
    // Half a texel from its block's ends, so that the filter never mixes two faces.
    let w = clamp(uvw.z, half_texel, 1.0 - half_texel);
    return textureSampleLevel(faces, volume_sampler, vec3f(uvw.xy, (f32(face) + w) / f32(FACES)), level);
}

// `level` counts from the faces' first, which is level 1 of the grid.
fn sample_faces(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let half_texel = 0.5 * exp2(ceil(level)) / f32(frame.grid_size.z >> 1);
    let x = sample_face(face_of(0, direction.x > 0.0), uvw, level, half_texel);
    let y = sample_face(face_of(1, direction.y > 0.0), uvw, level, half_texel);
    let z = sample_face(face_of(2, direction.z > 0.0), uvw, level, half_texel);
    let value = abs(direction.x) * x + abs(direction.y) * y + abs(direction.z) * z;
    return value / max(value.a, 1.0);
}

// Level 0 is the same from all sides. Level 1 says from which it is seen at all: where that is a quarter or more,
// level 0 counts in full.
const FACING_FULL = 0.25;

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    let coarse = sample_faces(uvw, max(level - 1.0, 0.0), direction);
    if (level >= 1.0) {
        return coarse;
    }
    let fine = textureSampleLevel(base, volume_sampler, uvw, 0.0) * saturate(coarse.a / FACING_FULL);
    return mix(fine, coarse, max(level, 0.0));
}
