// Radiance in 32 bits: three fractions of 9 bits and their exponent (EXT_texture_shared_exponent). Up to 65408, with steps of
// 1/512 of the largest channel or less; what is larger is clamped.

const LARGEST = 65408.0;

fn pack_radiance(radiance: vec3f) -> u32 {
    let c = clamp(radiance, vec3f(0.0), vec3f(LARGEST));
    let largest = max(c.r, max(c.g, c.b));
    var exponent = clamp(floor(log2(max(largest, 1e-30))) + 16.0, 0.0, 31.0);
    // Rounding may reach the next power of two, and so may an inexact logarithm.
    exponent += select(0.0, 1.0, round(largest * exp2(24.0 - exponent)) > 511.0);
    let bits = vec3u(round(c * exp2(24.0 - exponent)));
    return bits.r | (bits.g << 9) | (bits.b << 18) | (u32(exponent) << 27);
}

fn unpack_radiance(bits: u32) -> vec3f {
    return vec3f(vec3u(bits, bits >> 9, bits >> 18) & vec3u(511)) * exp2(f32(bits >> 27) - 24.0);
}
