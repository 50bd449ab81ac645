// Numbers kept where they mean something.

// The largest half-precision float.
const HALF_MAX = 65504.0;

// What an image of half floats can hold; beyond is as bright as it gets, not infinite.
fn in_half_range(value: vec3f) -> vec3f {
    return clamp(value, vec3f(-HALF_MAX), vec3f(HALF_MAX));
}

// `v` of length 1, or `other` where `v` has no direction.
fn unit_or(v: vec3f, other: vec3f) -> vec3f {
    let squared = dot(v, v);
    // The square of what is still normal: below, it may be flushed to zero. Above, it is infinite.
    return select(other, v * inverseSqrt(squared), squared > 1e-36 && squared < 1e38);
}
