// Which of 64 sets of directions a pixel or a voxel traces, as a turn in [0, 1), in the order of Bayer's matrix: next neighbours
// are turned the most differently, any 4 × 4 of them hold every sixteenth of a turn, and any 8 × 8 all sets once.

fn turn_at(place: vec2u) -> f32 {
    let x = place.x ^ place.y;
    let order = ((x & 1) << 5) | ((place.y & 1) << 4) | ((x & 2) << 2) | ((place.y & 2) << 1) | ((x & 4) >> 1) | ((place.y & 4) >> 2);
    return f32(order) / 64.0;
}
