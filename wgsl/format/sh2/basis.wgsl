// The first two bands of the real spherical harmonics, in the order 1, x, y, z (RAU eq. 5.1 with the constant
// of its figure B.3). The four coefficients stand one above the other along z in one texture: RGB is radiance
// times coverage. Alpha is opacity as seen along the axes: first what both sides have, then by how much the
// positive side of x, y and z has more than the negative.

const COEFFICIENTS = 4u;
// 1 / (2√π)
const SH0 = 0.28209479177387814;
// √3 / (2√π)
const SH1 = 0.4886025119029199;
// Coefficients of a one-sided Lambertian emitter of radiance 1 with normal n: √π, and √(3π)/2 · n.
const LOBE0 = 1.772453850905516;
const LOBE1 = 1.5349900619197328;

// Opacities seen from +x, +y, +z and from −x, −y, −z.
struct SixOpacities {
    positive: vec3f,
    negative: vec3f,
}

// Exact for one-sided surfaces; what is opaque from both sides along any axis is so along all, so that nothing leaks.
fn encode_opacity(six: SixOpacities) -> vec4f {
    let both = min(six.positive, six.negative);
    return vec4f(max(both.x, max(both.y, both.z)), six.positive - six.negative);
}

fn decode_opacity(alpha: vec4f) -> SixOpacities {
    return SixOpacities(saturate(alpha.x + max(alpha.yzw, vec3f(0.0))), saturate(alpha.x + max(-alpha.yzw, vec3f(0.0))));
}

// Mean opacity over the six directions: what radiance is multiplied by.
fn mean_opacity(alpha: vec4f) -> f32 {
    let more = abs(alpha.yzw);
    return alpha.x + (more.x + more.y + more.z) / 6.0;
}
