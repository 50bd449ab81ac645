//! Meshes made of rings of vertices.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};
use voxlume::scene::Mesh;

/// Adds a vertex.
pub fn push(mesh: &mut Mesh, position: Vec3, normal: Vec3) {
    mesh.positions.push(position);
    mesh.normals.push(normal);
    mesh.tangents.push(normal.any_orthonormal_vector().extend(1.0));
    mesh.uvs.push(Vec2::ZERO);
}

/// Two triangles for each quad between rings of vertices: `segments` + 1 rings of `sides`, the first at vertex `first`.
pub fn tube(mesh: &mut Mesh, first: u32, segments: u32, sides: u32) {
    for ring in 0..segments {
        for side in 0..sides {
            let at = |ring: u32, side: u32| first + ring * sides + side % sides;
            let [a, b, c, d] =
                [at(ring, side), at(ring, side + 1), at(ring + 1, side), at(ring + 1, side + 1)];
            mesh.triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
}

/// A torus around the y axis of radius 1 on the outside, of 2 × `segments` × `sides` triangles.
pub fn torus(segments: u32, sides: u32) -> Mesh {
    let mut mesh = Mesh { name: "torus".into(), ..Mesh::default() };
    for ring in 0..=segments {
        let (sin, cos) = (TAU * ring as f32 / segments as f32).sin_cos();
        let out = Vec3::new(cos, 0.0, -sin);
        for side in 0..sides {
            let (sin, cos) = (TAU * side as f32 / sides as f32).sin_cos();
            let normal = out * cos + Vec3::Y * sin;
            push(&mut mesh, out * 0.7 + normal * 0.3, normal);
        }
    }
    tube(&mut mesh, 0, segments, sides);
    mesh
}
