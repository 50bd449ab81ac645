// Six-face: level 0 is isotropic and shared by all faces, which part from level 1 up (DVS §1.1); or the faces
// begin at level 0, by the surface's normal (RAU §5.1.2).

import package::common::volume::block_texel;
import package::encoding::{VolumeTarget, encode_texel};
import package::format::faces::FACES;
import package::format::options::{BASE, BASE_DOMINANT, BASE_ISOTROPIC, BASE_WEIGHTED, EMPTY, EMPTY_BLACK, EMPTY_FILL};

var base_level0: VolumeTarget;
var faces_level0: VolumeTarget;

// How much of a surface of this normal a face shows; all of it where opposite surfaces cancel.
fn face_weight(normal: vec3f, face: u32) -> f32 {
    if (all(normal == vec3f(0.0))) {
        return 1.0;
    }
    let size = abs(normal);
    let cosine = max(select(normal, -normal, (face & 1) == 1)[face / 2], 0.0);
    if (BASE == BASE_DOMINANT) {
        // The first of equals.
        let axis = select(select(2u, 1u, size.y >= size.z), 0u, size.x >= size.y && size.x >= size.z);
        return select(0.0, 1.0, cosine > 0.0 && face / 2 == axis);
    }
    return select(cosine, cosine * cosine, BASE == BASE_WEIGHTED);
}

fn voxel_store(cell: vec3u, radiance: vec3f, normal: vec3f, opacity: f32) {
    let value = vec4f(radiance * opacity, opacity);
    if (BASE == BASE_ISOTROPIC) {
        textureStore(base_level0, cell, encode_texel(value));
        return;
    }
    let depth = textureDimensions(faces_level0).z;
    for (var face = 0u; face < FACES; face++) {
        let weight = face_weight(normal, face);
        var seen = value * weight;
        if (weight == 0.0 && EMPTY == EMPTY_BLACK) {
            seen = vec4f(vec3f(0.0), opacity);
        } else if (weight == 0.0 && EMPTY == EMPTY_FILL) {
            seen = value;
        }
        textureStore(faces_level0, block_texel(cell, face, FACES, depth), encode_texel(seen));
    }
}
