// What a picture of the voxels shows of each occupied cell, at the cell's place in `cells`.

import package::common::octahedral::{pack_normal, unpack_normal};

struct ShownVoxel {
    // The channel's value.
    color: vec3f,
    // Octahedral, or NO_NORMAL.
    normal: u32,
}

// Bits that no packed normal has, for a mean of opposite ones.
const NO_NORMAL = 0x80008000u;

fn pack_shown_normal(normal: vec3f) -> u32 {
    return select(pack_normal(normal), NO_NORMAL, all(normal == vec3f(0.0)));
}

fn shown_normal(shown: ShownVoxel) -> vec3f {
    return select(unpack_normal(shown.normal), vec3f(0.0), shown.normal == NO_NORMAL);
}

struct Params {
    /// What of a voxel is shown.
    channel: u32,
    /// The side that `opacity` and `radiance` are seen from, such as (0, 0, 1) for +z.
    direction: vec3f,
}

var<uniform> params: Params;

// Reflectance.
const CHANNEL_ALBEDO = 0u;
const CHANNEL_NORMAL = 1u;
// Cubes, their faces darker the more they turn away.
const CHANNEL_OCCUPANCY = 2u;
const CHANNEL_EMISSION = 3u;
// Of the volume, seen from the side `direction`.
const CHANNEL_OPACITY = 4u;
const CHANNEL_RADIANCE = 5u;
// The volume's radiance towards the camera.
const CHANNEL_LIT = 6u;
