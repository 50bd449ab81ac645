//! Which voxels triangles overlap, in `f64`.

use std::ops::RangeInclusive;

use glam::{DVec2, DVec3, IVec3};

use crate::Substrate;

/// Voxels: what is nearer than this to where the decision turns may be decided either way.
pub const EPSILON: f64 = 1e-3;

/// How thick voxelized surfaces are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separability {
    /// 26: every voxel that a triangle overlaps.
    Conservative,
    /// 6: RAU figure 4.5, with one voxel a column.
    Thin,
}

/// Where a bitmask differs from what it should be.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    /// Voxels that are overlapped and not set.
    pub missing: Vec<IVec3>,
    /// Voxels that are set and not overlapped.
    pub extra: Vec<IVec3>,
    /// Voxels too near to the decision to tell.
    pub undecided: usize,
    /// Voxels that are certainly overlapped.
    pub overlapped: usize,
}

/// Compares level 0 of a bitmask with triangles in voxel coordinates.
pub fn compare(
    substrate: &Substrate,
    triangles: &[[DVec3; 3]],
    separability: Separability,
    epsilon: f64,
) -> Comparison {
    let n = substrate.grid.size.map(|side| side as i32);
    let index = |cell: IVec3| ((cell.z * n[1] + cell.y) * n[0] + cell.x) as usize;
    // Bit 0: may be set; bit 1: must be set.
    let mut expected = vec![0u8; n.iter().product::<i32>() as usize];
    for triangle in triangles {
        let [x, y, z] = cells(triangle, epsilon, n);
        for cell in z.flat_map(|z| {
            let x = x.clone();
            y.clone().flat_map(move |y| x.clone().map(move |x| IVec3::new(x, y, z)))
        }) {
            let (must, may) = match separability {
                Separability::Conservative => conservative(triangle, cell, epsilon),
                Separability::Thin => thin(triangle, cell, epsilon),
            };
            expected[index(cell)] |= u8::from(may) | u8::from(must) << 1;
        }
    }
    let mut comparison = Comparison::default();
    for z in 0..n[2] {
        for y in 0..n[1] {
            for x in 0..n[0] {
                let cell = IVec3::new(x, y, z);
                let set = substrate.is_set(cell.as_uvec3(), 0);
                match expected[index(cell)] {
                    0 if set => comparison.extra.push(cell),
                    0 => {}
                    1 => comparison.undecided += 1,
                    _ => {
                        comparison.overlapped += 1;
                        if !set {
                            comparison.missing.push(cell);
                        }
                    }
                }
            }
        }
    }
    comparison
}

/// Cells of the triangle's bounding box, with a margin, within a grid of these sides.
fn cells(triangle: &[DVec3; 3], margin: f64, n: [i32; 3]) -> [RangeInclusive<i32>; 3] {
    let low = triangle[0].min(triangle[1]).min(triangle[2]) - margin;
    let high = triangle[0].max(triangle[1]).max(triangle[2]) + margin;
    [0, 1, 2].map(|i| (low[i].floor() as i32).max(0)..=(high[i].floor() as i32).min(n[i] - 1))
}

fn conservative(triangle: &[DVec3; 3], cell: IVec3, epsilon: f64) -> (bool, bool) {
    let centre = cell.as_dvec3() + 0.5;
    let may = overlaps_box(triangle, centre, 0.5 + epsilon);
    (may && overlaps_box(triangle, centre, 0.5 - epsilon), may)
}

/// Whether a triangle and a cube have a point in common: thirteen separating axes (Akenine-Möller, "Fast 3D
/// Triangle-Box Overlap Testing", Journal of Graphics Tools 6(1), 2001).
pub fn overlaps_box(triangle: &[DVec3; 3], centre: DVec3, half: f64) -> bool {
    let v = triangle.map(|corner| corner - centre);
    let edges = [v[1] - v[0], v[2] - v[1], v[0] - v[2]];
    let separates = |axis: DVec3| {
        let radius = half * axis.abs().element_sum();
        let [a, b, c] = v.map(|corner| corner.dot(axis));
        a.min(b).min(c) > radius || a.max(b).max(c) < -radius
    };
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    !(axes.into_iter().any(separates)
        || separates(edges[0].cross(edges[1]))
        || edges.iter().any(|edge| axes.iter().any(|axis| separates(axis.cross(*edge)))))
}

/// RAU figure 4.5 along each axis that may be the normal's dominant one.
fn thin(triangle: &[DVec3; 3], cell: IVec3, epsilon: f64) -> (bool, bool) {
    let normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[1]).abs();
    let axes = (0..3).filter(|axis| normal[*axis] >= normal.max_element() * (1.0 - 1e-4));
    let decisions: Vec<(bool, bool)> = axes.map(|axis| thin_along(triangle, cell, axis, epsilon)).collect();
    (decisions.iter().all(|(must, _)| *must), decisions.iter().any(|(_, may)| *may))
}

fn thin_along(triangle: &[DVec3; 3], cell: IVec3, axis: usize, epsilon: f64) -> (bool, bool) {
    // The dominant axis becomes z (RAU eq. 4.1).
    let turn = |v: DVec3| DVec3::from_array([1, 2, 3].map(|i| v[(axis + i) % 3]));
    let p = triangle.map(turn);
    let cell = turn(cell.as_dvec3());
    let normal = (p[1] - p[0]).cross(p[2] - p[1]);
    let size = normal.length();
    let mut decision = (true, true);
    let mut and = |must: bool, may: bool| decision = (decision.0 && must, decision.1 && may);
    for i in 0..3 {
        let [low, high] = [p[0][i].min(p[1][i]).min(p[2][i]), p[0][i].max(p[1][i]).max(p[2][i])];
        let within = |slack: f64| (low - slack).floor() <= cell[i] && cell[i] <= (high + slack).floor();
        and(within(-epsilon), within(epsilon));
    }
    // Where the plane crosses the column's middle.
    let depth = p[0].z + (normal.x * (p[0].x - cell.x - 0.5) + normal.y * (p[0].y - cell.y - 0.5)) / normal.z;
    let [low, high] = [(depth - epsilon).floor(), (depth + epsilon).floor()];
    and(low == high && low == cell.z, low <= cell.z && cell.z <= high);
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        let corners = p.map(|v| DVec2::new(v[i], v[j]));
        let middle = DVec2::new(cell[i], cell[j]) + 0.5;
        let facing = normal[k] / size;
        if facing.abs() < 1e-5 {
            // Seen edge-on, rounding decides which way the triangle turns.
            and(
                within_edges(&corners, middle, 1.0, -epsilon)
                    && within_edges(&corners, middle, -1.0, -epsilon),
                true,
            );
        } else {
            let sign = facing.signum();
            and(
                within_edges(&corners, middle, sign, -epsilon),
                within_edges(&corners, middle, sign, epsilon),
            );
        }
    }
    decision
}

/// Whether the square standing on its corner around `middle` touches the triangle's inner side of every edge.
fn within_edges(corners: &[DVec2; 3], middle: DVec2, sign: f64, slack: f64) -> bool {
    (0..3).all(|i| {
        let normal = (corners[(i + 1) % 3] - corners[i]).perp() * sign;
        let reach = 0.5 * normal.abs().max_element() + slack * normal.abs().element_sum();
        normal.dot(middle - corners[i]) + reach >= 0.0
    })
}
