// What an encoding can't hold: clamped, and counted, never wrapped.

struct OutOfRange {
    // Texels with such a value.
    values: atomic<u32>,
    // Bits of the largest one's magnitude: of floats that are not negative, larger ones have larger bits.
    worst: atomic<u32>,
}

@group(2) @binding(15) var<storage, read_write> out_of_range: OutOfRange;

fn clamp_to_range(value: vec4f, range: vec4f) -> vec4f {
    if (any(abs(value) > range)) {
        let beyond = select(vec4f(0.0), abs(value), abs(value) > range);
        atomicAdd(&out_of_range.values, 1u);
        atomicMax(&out_of_range.worst, bitcast<u32>(max(max(beyond.x, beyond.y), max(beyond.z, beyond.w))));
    }
    return clamp(value, -range, range);
}
