// What a triangle shows to a voxel: its point nearest the voxel's centre (RAU §4.1.5, without leaving the
// triangle) and the texture level whose texels are as large as the voxel.

import package::common::frame::frame;
import package::common::mesh::{vertices, triangle_indices};

struct Fragment {
    weights: vec3f,
    uv: vec2f,
    lod: f32,
}

// Barycentric weights of the point of triangle abc nearest to p: Ericson, Real-Time Collision
// Detection, §5.1.5.
fn nearest_weights(p: vec3f, a: vec3f, b: vec3f, c: vec3f) -> vec3f {
    let ab = b - a;
    let ac = c - a;
    let ap = p - a;
    let d1 = dot(ab, ap);
    let d2 = dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) { return vec3f(1.0, 0.0, 0.0); }
    let bp = p - b;
    let d3 = dot(ab, bp);
    let d4 = dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) { return vec3f(0.0, 1.0, 0.0); }
    let vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        let v = d1 / max(d1 - d3, 1e-30);
        return vec3f(1.0 - v, v, 0.0);
    }
    let cp = p - c;
    let d5 = dot(ab, cp);
    let d6 = dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) { return vec3f(0.0, 0.0, 1.0); }
    let vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        let w = d2 / max(d2 - d6, 1e-30);
        return vec3f(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        let w = (d4 - d3) / max(d4 - d3 + d5 - d6, 1e-30);
        return vec3f(0.0, 1.0 - w, w);
    }
    let scale = 1.0 / max(va + vb + vc, 1e-30);
    return vec3f(1.0 - (vb + vc) * scale, vb * scale, vc * scale);
}

fn fragment_at(triangle: u32, v: array<vec3f, 3>, center_voxel: vec3f) -> Fragment {
    let i = triangle_indices(triangle);
    let uv0 = vertices[i.x].uv;
    let uv1 = vertices[i.y].uv;
    let uv2 = vertices[i.z].uv;
    var f: Fragment;
    f.weights = nearest_weights(center_voxel, v[0], v[1], v[2]);
    f.uv = f.weights.x * uv0 + f.weights.y * uv1 + f.weights.z * uv2;
    let e1 = uv1 - uv0;
    let e2 = uv2 - uv0;
    let texels = abs(e1.x * e2.y - e1.y * e2.x) * f32(frame.texture_size) * f32(frame.texture_size);
    let voxels = length(cross(v[1] - v[0], v[2] - v[0]));
    f.lod = 0.5 * log2(max(texels / max(voxels, 1e-20), 1.0));
    return f;
}
