// Which share of an effect's or a voxel's directions a pixel or a voxel traces, in the order of Bayer's matrix: next neighbours
// are turned the most differently, and any tile of 4 × 4 or 8 × 8 holds all of its shares once.

import package::common::trace::{Share, WHOLE};

// `side` is 4 or 8; with 1 each place traces all.
fn share_at(place: vec2u, side: u32) -> Share {
    let x = place.x ^ place.y;
    let four = ((x & 1) << 3) | ((place.y & 1) << 2) | (x & 2) | ((place.y & 2) >> 1);
    if (side == 8) {
        return Share((four << 2) | ((x & 4) >> 1) | ((place.y & 4) >> 2), 64);
    }
    if (side == 4) {
        return Share(four, 16);
    }
    return WHOLE;
}
