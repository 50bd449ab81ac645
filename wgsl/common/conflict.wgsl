// Which reflectance a voxel gets where several triangles meet in it: their weighted mean, or what RAU §5.1.1 does
// with four bytes.

override CONFLICT: u32 = 0;
// Fixed-point sums: the same bits whatever the order.
const CONFLICT_SUM = 0u;
// The largest packed word: alpha, then red, green and blue decide (RAU's swizzle). Too bright, but of no order.
const CONFLICT_MAX = 1u;
// RAU figure B.1: the mean so far and its count, in bytes. Depends on the order, and begins anew after 255.
const CONFLICT_RUNNING_AVERAGE = 2u;

fn pack_reflectance(reflectance: vec3f, high: u32) -> u32 {
    // Cut off, not rounded, as figure B.1's conversion does.
    let bytes = vec3u(saturate(reflectance) * 255.0);
    return (high << 24) | (bytes.r << 16) | (bytes.g << 8) | bytes.b;
}

fn unpack_reflectance(word: u32) -> vec3f {
    return vec3f(vec3u(word >> 16, word >> 8, word) & vec3u(255)) / 255.0;
}

// The running mean with one more; its count wraps.
fn average_reflectance(word: u32, reflectance: vec3f) -> u32 {
    let count = word >> 24;
    let mean = (unpack_reflectance(word) * f32(count) + reflectance) / f32(count + 1);
    return pack_reflectance(mean, (count + 1) & 255);
}
