//! Triangles, as `struct Vertex` in wgsl/common/mesh.wgsl.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec2, Vec3, Vec4};
use rayon::prelude::*;
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

/// All triangles of a scene.
pub(crate) struct Whole {
    pub vertices: Vec<Vertex>,
    pub triangles: Vec<[u32; 3]>,
    /// Vertices and triangles that never move.
    pub still: (usize, usize),
    /// For [`moving`].
    pub order: Vec<u32>,
}

pub(crate) fn whole(scene: &Scene, origin: DVec3) -> Whole {
    let (geometry, moving) = (Geometry::new(scene, origin), Geometry::moving(scene, origin));
    let still = (
        geometry.positions.len() - moving.positions.len(),
        geometry.triangles.len() - moving.triangles.len(),
    );
    let (never, may) = geometry.triangles.split_at(still.1);
    let (first, order) = (order(scene, &geometry, never), order(scene, &geometry, may));
    let triangles = ordered(never, &first).chain(ordered(may, &order)).collect();
    Whole { vertices: vertices(&geometry), triangles, still, order }
}

/// Vertices and triangles of what moves, which follow `first_vertex` others, in the order that they had at first.
pub(crate) fn moving(
    scene: &Scene,
    origin: DVec3,
    first_vertex: usize,
    order: &[u32],
) -> (Vec<Vertex>, Vec<[u32; 3]>) {
    let geometry = Geometry::moving(scene, origin);
    let triangles = ordered(&geometry.triangles, order);
    (vertices(&geometry), triangles.map(|corners| corners.map(|i| i + first_vertex as u32)).collect())
}

fn ordered(triangles: &[[u32; 3]], order: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    order.iter().map(|&index| triangles[index as usize])
}

/// Those with an alpha mask last, as the plan has them voxelized apart, and else along a Morton curve by their centroids: in a
/// voxel the same one of two triangles in one plane is in front, whatever order a file gives them in.
fn order(scene: &Scene, geometry: &Geometry, triangles: &[[u32; 3]]) -> Vec<u32> {
    let corners = |triangle: &[u32; 3]| triangle.map(|i| geometry.positions[i as usize]);
    let centroid = |triangle: &[u32; 3]| corners(triangle).iter().sum::<Vec3>() / 3.0;
    let bounds = triangles.par_iter().map(centroid).map(|c| (c, c));
    let Some((low, high)) = bounds.reduce_with(|(l, h), (m, n)| (l.min(m), h.max(n))) else {
        return Vec::new();
    };
    let per_unit = MORTON_SIDE / (high - low).max_element().max(f32::MIN_POSITIVE);
    let key = |triangle: &[u32; 3]| {
        let material = geometry.materials[triangle[0] as usize] as usize;
        (scene.materials[material].is_masked(), morton((centroid(triangle) - low) * per_unit))
    };
    let mut keyed: Vec<_> = (0..triangles.len() as u32)
        .into_par_iter()
        .map(|index| (key(&triangles[index as usize]), index))
        .collect();
    let exact =
        |index: u32| corners(&triangles[index as usize]).map(|corner| corner.to_array().map(f32::to_bits));
    keyed.par_sort_unstable_by(|(key, index), (other_key, other)| {
        key.cmp(other_key).then_with(|| exact(*index).cmp(&exact(*other))).then(index.cmp(other))
    });
    keyed.into_iter().map(|(_, index)| index).collect()
}

/// Steps along a coordinate, of 21 bits.
const MORTON_SIDE: f32 = 2_097_151.0;

/// The bits of three coordinates in [0, 2²¹), in turn.
fn morton(at: Vec3) -> u64 {
    let spread = |value: f32| (0..21).fold(0, |sum, bit| sum | (value as u64 >> bit & 1) << (3 * bit));
    spread(at.x) | spread(at.y) << 1 | spread(at.z) << 2
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
