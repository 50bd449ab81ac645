// Six-face sampling: the three faces turned towards the observer, weighted by the squares of the
// direction's components (RAU §5.2.2 and figure B.2).

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
    let depth = f32(textureDimensions(faces).x >> u32(ceil(level)));
    let half_texel = 0.5 / max(depth, 1.0);
    let x = sample_face(face_of(0, direction.x > 0.0), uvw, level, half_texel);
    let y = sample_face(face_of(1, direction.y > 0.0), uvw, level, half_texel);
    let z = sample_face(face_of(2, direction.z > 0.0), uvw, level, half_texel);
    let value = abs(direction.x) * x + abs(direction.y) * y + abs(direction.z) * z;
    return value / max(value.a, 1.0);
}

fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f {
    if (level <= 0.0) {
        return textureSampleLevel(base, volume_sampler, uvw, 0.0);
    }
    let coarsest = f32(textureNumLevels(faces) - 1);
    let coarse = sample_faces(uvw, clamp(level - 1.0, 0.0, coarsest), direction);
    if (level >= 1.0) {
        return coarse;
    }
    return mix(textureSampleLevel(base, volume_sampler, uvw, 0.0), coarse, level);
}
