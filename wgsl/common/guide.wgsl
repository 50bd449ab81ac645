// What tells whether two pixels show the same surface, in one texel: where it is, in voxels, and the normal of its shading, as a
// whole number of three bytes; −1 where nothing is behind the pixel.

import package::common::surface::Surface;

struct Guide {
    position: vec3f,
    normal: vec3f,
    hit: bool,
}

fn pack_guide(surface: Surface) -> vec4f {
    let n = vec3u(round(surface.normal * 127.0) + 128.0);
    return vec4f(surface.position_voxel, select(-1.0, f32(n.x | (n.y << 8) | (n.z << 16)), surface.hit));
}

fn unpack_guide(texel: vec4f) -> Guide {
    let bits = u32(max(texel.w, 0.0));
    let n = vec3f(vec3u(bits, bits >> 8, bits >> 16) & vec3u(255));
    return Guide(texel.xyz, (n - 128.0) / 127.0, texel.w >= 0.0);
}

// Another pixel's surface is the same one where it lies this near to the plane, in voxels, and its normal's cosine
// with this one's is at least so much.
const SAME_PLANE = 1.0;
const SAME_NORMAL = 0.9;

fn same_surface(own: Guide, other: Guide) -> bool {
    let distance = abs(dot(other.position - own.position, own.normal));
    return other.hit && distance < SAME_PLANE && dot(other.normal, own.normal) > SAME_NORMAL;
}
