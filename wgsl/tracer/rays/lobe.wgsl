// Directions in a lobe. The sets that neighbours share out (see `Share`) are runs of one sequence, so that each is spread
// evenly, and all of them together are.

import package::common::basis::basis_around;
import package::common::constants::{GOLDEN, TAU};
import package::common::trace::{LOBE_CONE, LOBE_GGX, Lobe, Share};

struct TraceParams {
    /// Rays of a trace, [1, 256]; 3 unless given.
    rays: u32,
}

var<uniform> trace_params: TraceParams;

// Point number `index` of a set's in the unit square. Along x a set has one point in each of as many strata, and all sets together
// have them evenly; along y both follow the golden ratio.
fn sequence(index: u32, share: Share) -> vec2f {
    let across = (f32(share.index) + 0.5) / f32(share.count);
    return vec2f((f32(index) + across) / f32(trace_params.rays), fract(f32(index + share.index) * GOLDEN));
}

// Cosine-weighted about +z: the disc below it, evenly (Malley).
fn cosine_direction(u: vec2f) -> vec3f {
    let radius = sqrt(u.x);
    return vec3f(radius * cos(TAU * u.y), radius * sin(TAU * u.y), sqrt(max(1.0 - u.x, 0.0)));
}

// All directions within a cone about +z alike.
fn cone_direction(u: vec2f, half_sine: f32) -> vec3f {
    let low = sqrt(max(1.0 - half_sine * half_sine, 0.0));
    let z = 1.0 - u.x * (1.0 - low);
    let radius = sqrt(max(1.0 - z * z, 0.0));
    return vec3f(radius * cos(TAU * u.y), radius * sin(TAU * u.y), z);
}

// Of the microfacets that a viewer along `view` sees, about +z (Heitz, "Sampling the GGX Distribution of Visible Normals",
// JCGT 7(4), 2018).
fn visible_normal(u: vec2f, view: vec3f, alpha: f32) -> vec3f {
    let v = normalize(vec3f(alpha * view.xy, view.z));
    let across = select(vec3f(1.0, 0.0, 0.0), vec3f(-v.y, v.x, 0.0) * inverseSqrt(dot(v.xy, v.xy)), dot(v.xy, v.xy) > 1e-12);
    let radius = sqrt(u.x);
    let x = radius * cos(TAU * u.y);
    let y = mix(sqrt(max(1.0 - x * x, 0.0)), radius * sin(TAU * u.y), 0.5 * (1.0 + v.z));
    let n = x * across + y * cross(v, across) + sqrt(max(1.0 - x * x - y * y, 0.0)) * v;
    return normalize(vec3f(alpha * n.xy, max(n.z, 1e-6)));
}

// Direction number `index` of a set's, unit.
fn lobe_direction(lobe: Lobe, index: u32, share: Share) -> vec3f {
    let u = sequence(index, share);
    let basis = basis_around(lobe.axis);
    if (lobe.shape == LOBE_CONE) {
        return basis * cone_direction(u, lobe.width);
    }
    if (lobe.shape == LOBE_GGX) {
        let facet = basis * visible_normal(u, lobe.view * basis, lobe.width * lobe.width);
        return reflect(-lobe.view, facet);
    }
    return basis * cosine_direction(u);
}
