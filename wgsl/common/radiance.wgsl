// Radiance in 32 bits: three fractions of 8 bits and their exponent (Ward, "Real Pixels", Graphics Gems II, 1991). Steps are 1/256
// of the largest channel or less, from 10⁻³⁰ to 10³⁰.

fn pack_radiance(radiance: vec3f) -> u32 {
    let c = clamp(radiance, vec3f(0.0), vec3f(1e30));
    let largest = max(c.r, max(c.g, c.b));
    if (largest < 1e-30) {
        return 0;
    }
    var exponent = floor(log2(largest)) + 1.0;
    // Rounding may reach the next power of two, and so may an inexact logarithm.
    exponent += select(0.0, 1.0, round(largest * exp2(8.0 - exponent)) > 255.0);
    let bits = vec3u(round(c * exp2(8.0 - exponent)));
    return bits.r | (bits.g << 8) | (bits.b << 16) | (u32(exponent + 128.0) << 24);
}

fn unpack_radiance(bits: u32) -> vec3f {
    return vec3f(vec3u(bits, bits >> 8, bits >> 16) & vec3u(255)) * exp2(f32(bits >> 24) - 136.0);
}
