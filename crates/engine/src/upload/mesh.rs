//! Triangles, as `struct Vertex` in wgsl/common/mesh.wgsl.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec2, Vec3, Vec4};
use voxlume_scene::{Geometry, Scene};

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Vertex {
    pub(super) position: Vec3,
    pub(super) material: u32,
    pub(super) normal: u32,
    pub(super) tangent: u32,
    pub(super) uv: Vec2,
}

fn vertices(geometry: &Geometry) -> Vec<Vertex> {
    let count = geometry.positions.len();
    (0..count)
        .map(|i| Vertex {
            position: geometry.positions[i],
            material: geometry.materials[i],
            normal: pack_normal(geometry.normals[i]),
            tangent: pack_tangent(geometry.tangents[i]),
            uv: geometry.uvs[i],
        })
        .collect()
}

/// All vertices and triangles, and how many of each never move.
pub(crate) fn whole(scene: &Scene, origin: DVec3) -> (Vec<Vertex>, Vec<[u32; 3]>, (usize, usize)) {
    let (geometry, moving) = (Geometry::new(scene, origin), Geometry::moving(scene, origin));
    let still = (
        geometry.positions.len() - moving.positions.len(),
        geometry.triangles.len() - moving.triangles.len(),
    );
    let mut triangles = geometry.triangles.clone();
    let (never, may) = triangles.split_at_mut(still.1);
    masked_last(scene, &geometry, never);
    masked_last(scene, &geometry, may);
    (vertices(&geometry), triangles, still)
}

/// Vertices and triangles of what moves, which follow `first_vertex` others.
pub(crate) fn moving(scene: &Scene, origin: DVec3, first_vertex: usize) -> (Vec<Vertex>, Vec<[u32; 3]>) {
    let geometry = Geometry::moving(scene, origin);
    let mut triangles = geometry.triangles.clone();
    masked_last(scene, &geometry, &mut triangles);
    triangles.iter_mut().flatten().for_each(|index| *index += first_vertex as u32);
    (vertices(&geometry), triangles)
}

/// As the plan has them voxelized apart.
fn masked_last(scene: &Scene, geometry: &Geometry, triangles: &mut [[u32; 3]]) {
    triangles.sort_by_key(|triangle| {
        scene.materials[geometry.materials[triangle[0] as usize] as usize].is_masked()
    });
}

/// Octahedral map: Cigolle et al., JCGT 3(2), 2014. The inverse of wgsl/common/octahedral.wgsl.
fn octahedral(n: Vec3) -> [i16; 2] {
    let n = n / (n.x.abs() + n.y.abs() + n.z.abs()).max(1e-30);
    let sign = |v: f32| if v >= 0.0 { 1.0 } else { -1.0 };
    let (x, y) =
        if n.z >= 0.0 { (n.x, n.y) } else { ((1.0 - n.y.abs()) * sign(n.x), (1.0 - n.x.abs()) * sign(n.y)) };
    [x, y].map(|v| (v.clamp(-1.0, 1.0) * 32767.0).round() as i16)
}

fn pack_normal(n: Vec3) -> u32 {
    let [x, y] = octahedral(n);
    u32::from(x as u16) | u32::from(y as u16) << 16
}

/// The lowest bit of y is the bitangent's sign.
fn pack_tangent(t: Vec4) -> u32 {
    let bits = pack_normal(t.truncate()) & 0xfffe_ffff;
    if t.w < 0.0 { bits | 0x1_0000 } else { bits }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decode(bits: u32) -> Vec3 {
        let [x, y] =
            [bits as u16 as i16, (bits >> 16) as u16 as i16].map(|v| (f32::from(v) / 32767.0).max(-1.0));
        let mut v = Vec3::new(x, y, 1.0 - x.abs() - y.abs());
        let t = (-v.z).max(0.0);
        v.x += if v.x >= 0.0 { -t } else { t };
        v.y += if v.y >= 0.0 { -t } else { t };
        v.normalize()
    }

    #[test]
    fn octahedral_normals_are_exact_to_a_ten_thousandth() {
        for i in 0..1000 {
            let z = -1.0 + 2.0 * i as f32 / 999.0;
            let (s, c) = (i as f32 * 2.399_963).sin_cos();
            let r = (1.0 - z * z).max(0.0).sqrt();
            let n = Vec3::new(r * c, r * s, z);
            assert!(decode(pack_normal(n)).distance(n) < 1e-4, "{n}");
        }
    }
}
