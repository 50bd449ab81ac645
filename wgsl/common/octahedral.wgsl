// Unit vectors in 32 bits: octahedral map of Cigolle et al., "A Survey of Efficient Representations for
// Independent Unit Vectors", JCGT 3(2), 2014.

// Of a vector of any length, two coordinates in [−1, 1].
fn octahedral_encode(v: vec3f) -> vec2f {
    let p = v.xy / max(abs(v.x) + abs(v.y) + abs(v.z), 1e-30);
    return select((1.0 - abs(p.yx)) * select(vec2f(-1.0), vec2f(1.0), p >= vec2f(0.0)), p, v.z >= 0.0);
}

fn octahedral_decode(e: vec2f) -> vec3f {
    var v = vec3f(e, 1.0 - abs(e.x) - abs(e.y));
    let t = max(-v.z, 0.0);
    v.x += select(t, -t, v.x >= 0.0);
    v.y += select(t, -t, v.y >= 0.0);
    return normalize(v);
}

fn unpack_normal(bits: u32) -> vec3f {
    return octahedral_decode(unpack2x16snorm(bits));
}

fn pack_normal(n: vec3f) -> u32 {
    return pack2x16snorm(octahedral_encode(n));
}

// The tangent's lowest bit of y is the bitangent's sign.
fn unpack_tangent(bits: u32) -> vec4f {
    let direction = octahedral_decode(unpack2x16snorm(bits & 0xfffeffff));
    return vec4f(direction, select(1.0, -1.0, (bits & 0x10000) != 0));
}
