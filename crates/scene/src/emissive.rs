//! Surfaces that emit evenly, as the polygons that area lights are sampled by.

use std::collections::HashMap;

use glam::{DVec3, Vec3};

use crate::{EmissivePolygon, Instance, Mesh, Scene};

impl Scene {
    /// The triangles whose materials emit, relative to `origin`; two that lie in a plane, share an edge and
    /// make a convex quadrilateral are one polygon. Triangles without area are left out.
    ///
    /// `None` if there are more than `limit` polygons, or if a material's emission varies over it by a
    /// texture or an alpha mask: then emission is better gathered from voxels.
    pub fn emissive_polygons(&self, origin: DVec3, limit: usize) -> Option<Vec<EmissivePolygon>> {
        let mut polygons = Vec::new();
        for instance in &self.instances {
            let mesh = &self.meshes[instance.mesh];
            let material = &self.materials[mesh.material];
            if material.emission == Vec3::ZERO {
                continue;
            }
            if material.emission_texture.is_some() || material.alpha_cutoff.is_some() {
                return None;
            }
            // A polygon takes two triangles at most. Merged as they are in the mesh, so that a pose changes no count.
            let triangles = own_triangles(mesh, 2 * (limit - polygons.len()))?;
            polygons.extend(merge(&triangles).iter().map(|corners| EmissivePolygon {
                corners: placed(instance, corners, origin),
                radiance: material.emission,
                double_sided: material.double_sided,
            }));
            if polygons.len() > limit {
                return None;
            }
        }
        Some(polygons)
    }
}

/// Triangles with an area, in the mesh's own space; `None` if there are more than `limit`.
fn own_triangles(mesh: &Mesh, limit: usize) -> Option<Vec<[Vec3; 3]>> {
    let corners = mesh.triangles.iter().map(|triangle| triangle.map(|i| mesh.positions[i as usize]));
    let triangles: Vec<_> =
        corners.filter(|corners| unit_normal(corners) != DVec3::ZERO).take(limit + 1).collect();
    (triangles.len() <= limit).then_some(triangles)
}

/// In the world less `origin`, counter-clockwise from the front.
fn placed(instance: &Instance, corners: &[Vec3], origin: DVec3) -> Vec<Vec3> {
    let place = |p: &Vec3| (instance.transform.transform_point3(p.as_dvec3()) - origin).as_vec3();
    let mut corners: Vec<Vec3> = corners.iter().map(place).collect();
    if instance.transform.matrix3.determinant() < 0.0 {
        corners.reverse();
    }
    corners
}

fn unit_normal(corners: &[Vec3; 3]) -> DVec3 {
    crate::vertex::area_normal(*corners).normalize_or_zero()
}

/// Merges each triangle with the first later one that makes a quadrilateral with it.
fn merge(triangles: &[[Vec3; 3]]) -> Vec<Vec<Vec3>> {
    // Vertices may be stored once per face, so edges are known by their ends' positions.
    let key = |p: Vec3| (p + Vec3::ZERO).to_array().map(f32::to_bits);
    let mut edges: HashMap<_, Vec<(usize, usize)>> = HashMap::new();
    for (t, corners) in triangles.iter().enumerate() {
        for edge in 0..3 {
            edges.entry((key(corners[edge]), key(corners[(edge + 1) % 3]))).or_default().push((t, edge));
        }
    }
    let mut used = vec![false; triangles.len()];
    let mut polygons = Vec::new();
    for (t, corners) in triangles.iter().enumerate() {
        if std::mem::replace(&mut used[t], true) {
            continue;
        }
        let mut neighbours = (0..3).flat_map(|edge| {
            let shared = (key(corners[(edge + 1) % 3]), key(corners[edge]));
            edges.get(&shared).into_iter().flatten().map(move |found| (edge, *found))
        });
        let quad = neighbours.find_map(|(edge, (other, other_edge))| {
            let apex = triangles[other][(other_edge + 2) % 3];
            let quad = [corners[edge], apex, corners[(edge + 1) % 3], corners[(edge + 2) % 3]];
            (!used[other] && is_planar_convex(&quad)).then_some((other, quad))
        });
        match quad {
            Some((other, quad)) => {
                used[other] = true;
                polygons.push(quad.to_vec());
            }
            None => polygons.push(corners.to_vec()),
        }
    }
    polygons
}

/// Within what `f32` positions can tell.
fn is_planar_convex(quad: &[Vec3; 4]) -> bool {
    const TOLERANCE: f64 = 1e-5;
    let corner = |i: usize| quad[i % 4].as_dvec3();
    let normal = (corner(2) - corner(0)).cross(corner(3) - corner(1)).normalize_or_zero();
    (0..4).all(|i| {
        let (before, after) = (corner(i + 1) - corner(i), corner(i + 2) - corner(i + 1));
        let flat = before.dot(normal).abs() <= TOLERANCE * before.length();
        let turn = before.cross(after).dot(normal);
        flat && turn > TOLERANCE * before.length() * after.length()
    })
}
