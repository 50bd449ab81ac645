//! Normals and tangents that every vertex has, whatever the file says.

use std::collections::HashMap;

use glam::{DVec3, Vec3, Vec4};

use crate::Mesh;

/// Twice the triangle's area along its normal; in `f64`, so that tiny triangles have one.
pub(crate) fn area_normal([a, b, c]: [Vec3; 3]) -> DVec3 {
    let [a, b, c] = [a, b, c].map(Vec3::as_dvec3);
    (b - a).cross(c - a)
}

/// Makes normals unit. One without a length becomes the mean of its triangles' normals by area, +y if they
/// have none.
pub(crate) fn unit_normals(positions: &[Vec3], triangles: &[[u32; 3]], normals: &mut [Vec3]) {
    let mut lost: HashMap<u32, DVec3> = HashMap::new();
    for (i, normal) in (0..).zip(normals.iter_mut()) {
        let unit = normal.as_dvec3().normalize_or_zero();
        *normal = unit.as_vec3();
        if unit == DVec3::ZERO {
            lost.insert(i, DVec3::ZERO);
        }
    }
    if lost.is_empty() {
        return;
    }
    for triangle in triangles {
        let face = area_normal(triangle.map(|i| positions[i as usize]));
        for corner in triangle {
            lost.entry(*corner).and_modify(|sum| *sum += face);
        }
    }
    for (i, sum) in lost {
        normals[i as usize] = sum.try_normalize().unwrap_or(DVec3::Y).as_vec3();
    }
}

/// Gives each triangle vertices of its own with the triangle's normal.
pub(crate) fn flat_normals(mesh: &mut Mesh) {
    let corners = || mesh.triangles.iter().flatten().map(|i| *i as usize);
    let positions: Vec<Vec3> = corners().map(|i| mesh.positions[i]).collect();
    let uvs = corners().map(|i| mesh.uvs[i]).collect();
    let (faces, _) = positions.as_chunks::<3>();
    let normals = faces.iter().flat_map(|face| {
        let normal = area_normal(*face).try_normalize().unwrap_or(DVec3::Y).as_vec3();
        [normal; 3]
    });
    mesh.normals = normals.collect();
    mesh.triangles = (0..faces.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    (mesh.positions, mesh.uvs) = (positions, uvs);
}

/// A tangent for where any will do.
pub(crate) fn any_tangent(normal: Vec3) -> Vec4 {
    normal.any_orthonormal_vector().extend(1.0)
}

/// Makes tangents unit and their signs ±1; one without a length becomes any.
pub(crate) fn unit_tangents(normals: &[Vec3], tangents: &mut [Vec4]) {
    for (tangent, normal) in tangents.iter_mut().zip(normals) {
        let unit = tangent.truncate().as_dvec3().normalize_or_zero().as_vec3();
        let sign = if tangent.w < 0.0 { -1.0 } else { 1.0 };
        *tangent = if unit == Vec3::ZERO { any_tangent(*normal) } else { unit.extend(sign) };
    }
}

/// Tangents by MikkTSpace, as glTF wants them for normal maps (2.0 §3.7.2.1). Vertices whose triangles
/// disagree, as at mirrored texture coordinates, are split.
pub(crate) fn mikktspace_tangents(mesh: &mut Mesh) {
    let mut corners = Corners { tangents: vec![Vec4::ZERO; mesh.triangles.len() * 3], mesh };
    // The error type has no values.
    let _ = bevy_mikktspace::generate_tangents(&mut corners);
    let Corners { tangents, mesh } = corners;

    let mut known: HashMap<(u32, [u32; 4]), u32> = HashMap::new();
    mesh.tangents = mesh.normals.iter().map(|normal| any_tangent(*normal)).collect();
    let mut taken = vec![false; mesh.positions.len()];
    for (corner, tangent) in mesh.triangles.iter_mut().flatten().zip(tangents) {
        if tangent == Vec4::ZERO || !tangent.is_finite() {
            continue;
        }
        let old = *corner;
        *corner = *known.entry((old, tangent.to_array().map(f32::to_bits))).or_insert_with(|| {
            let i = old as usize;
            if !std::mem::replace(&mut taken[i], true) {
                mesh.tangents[i] = tangent;
                return old;
            }
            mesh.positions.push(mesh.positions[i]);
            mesh.normals.push(mesh.normals[i]);
            mesh.uvs.push(mesh.uvs[i]);
            mesh.tangents.push(tangent);
            mesh.positions.len() as u32 - 1
        });
    }
}

struct Corners<'a> {
    mesh: &'a mut Mesh,
    /// Three per triangle, zero where there is none.
    tangents: Vec<Vec4>,
}

impl Corners<'_> {
    fn vertex(&self, face: usize, corner: usize) -> usize {
        self.mesh.triangles[face][corner] as usize
    }
}

impl bevy_mikktspace::Geometry for Corners<'_> {
    fn num_faces(&self) -> usize {
        self.mesh.triangles.len()
    }

    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }

    fn position(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.positions[self.vertex(face, corner)].to_array()
    }

    fn normal(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.normals[self.vertex(face, corner)].to_array()
    }

    /// MikkTSpace thinks v upwards, glTF has it downwards.
    fn tex_coord(&self, face: usize, corner: usize) -> [f32; 2] {
        let uv = self.mesh.uvs[self.vertex(face, corner)];
        [uv.x, 1.0 - uv.y]
    }

    fn set_tangent(&mut self, space: Option<bevy_mikktspace::TangentSpace>, face: usize, corner: usize) {
        if let Some(space) = space {
            self.tangents[face * 3 + corner] = Vec4::from(space.tangent_encoded());
        }
    }
}
