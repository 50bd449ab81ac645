// What tells whether two pixels show the same surface, in one texel: where it is, in voxels, and a whole number that holds the
// normal of its shading and, where the texel stands for a block of pixels, which of them it is most like. Guides of half the
// size follow each other: see pass/reduce.wgsl.

import package::common::octahedral::{octahedral_decode, octahedral_encode};

struct Guide {
    position: vec3f,
    normal: vec3f,
    // Of the block that the texel stands for, in pixels from its first.
    pixel: vec2u,
    hit: bool,
}

// Steps of each of the normal's two coordinates, even so that the axes are exact: with three bits for each of the pixel's
// coordinates, a float holds all 24 bits.
const STEPS = 510.0;

fn pack_guide(guide: Guide) -> vec4f {
    let n = vec2u(round((octahedral_encode(guide.normal) * 0.5 + 0.5) * STEPS));
    let bits = n.x | (n.y << 9) | (guide.pixel.x << 18) | (guide.pixel.y << 21);
    return vec4f(guide.position, select(-1.0, f32(bits), guide.hit));
}

fn unpack_guide(texel: vec4f) -> Guide {
    let bits = vec4u(u32(max(texel.w, 0.0)));
    let parts = (bits >> vec4u(0, 9, 18, 21)) & vec4u(511, 511, 7, 7);
    let normal = octahedral_decode(vec2f(parts.xy) / STEPS * 2.0 - 1.0);
    return Guide(texel.xyz, normal, parts.zw, texel.w >= 0.0);
}

// Another pixel's surface is the same one where it lies this near to the plane, in voxels, and its normal's cosine
// with this one's is at least so much.
const GUIDE_PLANE = 1.0;
const GUIDE_NORMAL = 0.9;

fn same_surface(own: Guide, other: Guide) -> bool {
    let distance = abs(dot(other.position - own.position, own.normal));
    return other.hit && distance < GUIDE_PLANE && dot(other.normal, own.normal) > GUIDE_NORMAL;
}
