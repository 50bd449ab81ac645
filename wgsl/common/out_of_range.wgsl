// What an encoding can't hold: clamped, and counted, never wrapped.

struct OutOfRange {
    // Texels with such a value.
    values: atomic<u32>,
    // Bits of the largest one's magnitude: of floats that are not negative, larger ones have larger bits.
    worst: atomic<u32>,
}

var<storage, read_write> out_of_range: OutOfRange;

// No encoding that has a range tells its largest number from one that is larger by this share.
const ROUNDING = 1.0 / 4096.0;

fn clamp_to_range(value: vec4f, range: vec4f) -> vec4f {
    let is_beyond = abs(value) > range * (1.0 + ROUNDING);
    if (any(is_beyond)) {
        let beyond = select(vec4f(0.0), abs(value), is_beyond);
        atomicAdd(&out_of_range.values, 1u);
        atomicMax(&out_of_range.worst, bitcast<u32>(max(max(beyond.x, beyond.y), max(beyond.z, beyond.w))));
    }
    return clamp(value, -range, range);
}
