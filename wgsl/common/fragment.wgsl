// What a triangle shows to a voxel: its point nearest the voxel's centre (RAU §4.1.5, without leaving the
// triangle) and the texture level whose texels are as large as the voxel.

import package::common::material::{Material, shading_normal, HAS_TEXTURES, TEXTURE_SIZE};
import package::common::mesh::{vertices, triangle_indices};
import package::common::octahedral::{unpack_normal, unpack_tangent};
import package::common::range::unit_or;

// A triangle's corners, read once for all its voxels.
struct Corners {
    // Voxels.
    v: array<vec3f, 3>,
    uv: array<vec2f, 3>,
    normal: array<vec3f, 3>,
    tangent: array<vec4f, 3>,
    material: u32,
    // Of the texture arrays.
    lod: f32,
}

struct Fragment {
    weights: vec3f,
    uv: vec2f,
    lod: f32,
}

fn corners_of(triangle: u32, v: array<vec3f, 3>) -> Corners {
    var c: Corners;
    c.v = v;
    let i = triangle_indices(triangle);
    c.material = vertices[i.x].material;
    c.normal = array(
        unpack_normal(vertices[i.x].normal), unpack_normal(vertices[i.y].normal), unpack_normal(vertices[i.z].normal));
    if (HAS_TEXTURES) {
        c.tangent = array(unpack_tangent(vertices[i.x].tangent), unpack_tangent(vertices[i.y].tangent),
            unpack_tangent(vertices[i.z].tangent));
        c.uv = array(vertices[i.x].uv, vertices[i.y].uv, vertices[i.z].uv);
        let e1 = c.uv[1] - c.uv[0];
        let e2 = c.uv[2] - c.uv[0];
        let texels = abs(e1.x * e2.y - e1.y * e2.x) * TEXTURE_SIZE * TEXTURE_SIZE;
        let voxels = length(cross(v[1] - v[0], v[2] - v[0]));
        // Whole, so that one level is read and not two.
        c.lod = round(0.5 * log2(max(texels / max(voxels, 1e-20), 1.0)));
    }
    return c;
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

fn fragment_at(c: Corners, center_voxel: vec3f) -> Fragment {
    let w = nearest_weights(center_voxel, c.v[0], c.v[1], c.v[2]);
    return Fragment(w, w.x * c.uv[0] + w.y * c.uv[1] + w.z * c.uv[2], c.lod);
}

// Unit, normal map included.
fn fragment_normal(c: Corners, f: Fragment, material: Material) -> vec3f {
    let n = f.weights.x * c.normal[0] + f.weights.y * c.normal[1] + f.weights.z * c.normal[2];
    // Opposite normals of corners may cancel.
    let normal = unit_or(n, c.normal[0]);
    if (!HAS_TEXTURES) {
        return normal;
    }
    let tangent = f.weights.x * c.tangent[0] + f.weights.y * c.tangent[1] + f.weights.z * c.tangent[2];
    return shading_normal(material, f.uv, f.lod, normal, tangent);
}
