// Which of 16 sets of directions a pixel or a voxel traces, as a turn in [0, 1), in the order of Bayer's matrix: next
// neighbours are turned the most differently, and any 4 × 4 of them hold all sets once.

fn turn_at(place: vec2u) -> f32 {
    let x = place.x ^ place.y;
    let order = ((x & 1) << 3) | ((place.y & 1) << 2) | (x & 2) | ((place.y & 2) >> 1);
    return f32(order) / 16.0;
}
