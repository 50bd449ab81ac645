//! Built-in shapes as meshes.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3, Vec2, Vec3};

use crate::{Mesh, vertex};

/// Vertices and faces, counter-clockwise from the front.
#[derive(Default)]
struct Builder(Mesh);

impl Builder {
    fn vertex(&mut self, position: DVec3, normal: DVec3, uv: DVec2) -> u32 {
        self.0.positions.push(position.as_vec3());
        self.0.normals.push(normal.as_vec3());
        self.0.uvs.push(uv.as_vec2());
        self.0.positions.len() as u32 - 1
    }

    fn quad(&mut self, [a, b, c, d]: [u32; 4]) {
        self.0.triangles.extend([[a, b, c], [a, c, d]]);
    }

    /// A row per `v`, a column per `u`, from a function of (u, v) in [0,1]² whose v goes to the left of its
    /// u.
    fn sheet(&mut self, [columns, rows]: [u32; 2], point: impl Fn(f64, f64) -> (DVec3, DVec3)) {
        let first = self.0.positions.len() as u32;
        for row in 0..=rows {
            for column in 0..=columns {
                let (u, v) = (f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
                let (position, normal) = point(u, v);
                self.vertex(position, normal, DVec2::new(u, 1.0 - v));
            }
        }
        for row in 0..rows {
            for column in 0..columns {
                let corner = |c, r| first + (row + r) * (columns + 1) + column + c;
                self.quad([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]);
            }
        }
    }

    /// A disc at `centre`, facing `normal`, which is ±y.
    fn disc(&mut self, centre: DVec3, normal: DVec3, radius: f64, segments: u32) {
        let middle = self.vertex(centre, normal, DVec2::splat(0.5));
        let rim = |i: u32| circle(f64::from(i) / f64::from(segments));
        let ring: Vec<u32> = (0..segments)
            .map(|i| self.vertex(centre + rim(i) * radius, normal, (rim(i).xz_plane() + DVec2::ONE) / 2.0))
            .collect();
        for (i, &from) in ring.iter().enumerate() {
            let to = ring[(i + 1) % ring.len()];
            self.0.triangles.push(if normal.y > 0.0 { [middle, from, to] } else { [middle, to, from] });
        }
    }

    fn finish(mut self) -> Mesh {
        self.0.tangents = self.0.normals.iter().map(|normal| vertex::any_tangent(*normal)).collect();
        self.0
    }
}

trait Plane {
    fn xz_plane(self) -> DVec2;
}

impl Plane for DVec3 {
    fn xz_plane(self) -> DVec2 {
        DVec2::new(self.x, self.z)
    }
}

/// The unit circle in the xz plane, counter-clockwise seen from +y.
fn circle(turn: f64) -> DVec3 {
    let (sin, cos) = (turn * TAU).sin_cos();
    DVec3::new(cos, 0.0, -sin)
}

/// Four corners, counter-clockwise from the front. They should lie in a plane: there is one normal.
pub(crate) fn quad(corners: [DVec3; 4]) -> Mesh {
    let mut mesh = Builder::default();
    // Newell's: the best plane's if the corners are in none.
    let normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalize_or(DVec3::Y);
    let uvs = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)].map(DVec2::from);
    let face: Vec<u32> =
        corners.iter().zip(uvs).map(|(corner, uv)| mesh.vertex(*corner, normal, uv)).collect();
    mesh.quad([face[0], face[1], face[2], face[3]]);
    mesh.finish()
}

/// The box between two corners.
pub(crate) fn cuboid(low: DVec3, high: DVec3) -> Mesh {
    let mut mesh = Builder::default();
    let (centre, half) = (low.midpoint(high), (high - low) / 2.0);
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let mut normal = DVec3::ZERO;
            normal[axis] = sign;
            let mut u = DVec3::ZERO;
            u[(axis + 1) % 3] = 1.0;
            let v = normal.cross(u);
            let at = |s: f64, t: f64| centre + half * (normal + u * s + v * t);
            mesh.sheet([1, 1], |s, t| (at(2.0 * s - 1.0, 2.0 * t - 1.0), normal));
        }
    }
    mesh.finish()
}

/// A rectangle around the origin in the xz plane, facing +y, cut into cells.
pub(crate) fn grid(size: DVec2, cells: [u32; 2]) -> Mesh {
    let mut mesh = Builder::default();
    mesh.sheet(cells, |u, v| (DVec3::new((u - 0.5) * size.x, 0.0, (0.5 - v) * size.y), DVec3::Y));
    mesh.finish()
}

/// A disc around the origin in the xz plane, facing +y.
pub(crate) fn disc(radius: f64, segments: u32) -> Mesh {
    let mut mesh = Builder::default();
    mesh.disc(DVec3::ZERO, DVec3::Y, radius, segments);
    mesh.finish()
}

/// A closed cylinder around the y axis, from y = 0 to `height`.
pub(crate) fn cylinder(radius: f64, height: f64, segments: u32) -> Mesh {
    let mut mesh = Builder::default();
    mesh.sheet([segments, 1], |u, v| (circle(u) * radius + DVec3::Y * v * height, circle(u)));
    mesh.disc(DVec3::Y * height, DVec3::Y, radius, segments);
    mesh.disc(DVec3::ZERO, -DVec3::Y, radius, segments);
    mesh.finish()
}

/// A sphere around the origin, of `segments` meridians and half as many bands.
pub(crate) fn sphere(radius: f64, segments: u32) -> Mesh {
    let mut mesh = Builder::default();
    mesh.sheet([segments, (segments / 2).max(2)], |u, v| {
        let (sin, cos) = (v * PI).sin_cos();
        let normal = circle(u) * sin - DVec3::Y * cos;
        (normal * radius, normal)
    });
    let mut mesh = mesh.finish();
    // At the poles a band's quads have an edge without length.
    mesh.triangles.retain(|t| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        let near = |p: Vec3, q: Vec3| p.distance(q) <= 1e-6 * radius as f32;
        !(near(a, b) || near(b, c) || near(c, a))
    });
    mesh
}

/// Triangles as given, with flat normals. Every index must be in range.
pub(crate) fn triangles(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Mesh {
    let uvs = vec![Vec2::ZERO; positions.len()];
    let mut mesh = Builder(Mesh { positions, uvs, triangles, ..Mesh::default() });
    vertex::flat_normals(&mut mesh.0);
    mesh.finish()
}

/// Turns a closed shape's front inwards.
pub(crate) fn turn_inside_out(mesh: &mut Mesh) {
    mesh.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    mesh.normals.iter_mut().for_each(|normal| *normal = -*normal);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area's sum, and the volume that the fronts enclose.
    fn measure(mesh: &Mesh) -> (f64, f64) {
        let mut measured = (0.0, 0.0);
        for triangle in &mesh.triangles {
            let corners = triangle.map(|i| mesh.positions[i as usize]);
            let area = vertex::area_normal(corners);
            for i in triangle {
                let normal = mesh.normals[*i as usize];
                assert!((normal.length() - 1.0).abs() < 1e-5);
                assert!(normal.as_dvec3().dot(area) > 0.0, "the normal is at the back");
            }
            measured.0 += area.length() / 2.0;
            measured.1 += corners[0].as_dvec3().dot(area) / 6.0;
        }
        measured
    }

    fn close((area, volume): (f64, f64), expected: (f64, f64), tolerance: f64) {
        assert!((area / expected.0 - 1.0).abs() < tolerance, "area {area}, expected {}", expected.0);
        assert!((volume - expected.1).abs() <= tolerance * expected.0, "volume {volume}, not {}", expected.1);
    }

    #[test]
    fn shapes_have_their_area_and_volume() {
        let cube = cuboid(DVec3::new(1.0, 2.0, 3.0), DVec3::new(2.0, 4.0, 6.0));
        close(measure(&cube), (22.0, 6.0), 1e-6);
        assert_eq!((cube.positions.len(), cube.triangles.len()), (24, 12));
        close(measure(&sphere(2.0, 128)), (16.0 * PI, 32.0 / 3.0 * PI), 2e-3);
        close(measure(&cylinder(1.0, 3.0, 256)), (8.0 * PI, 3.0 * PI), 1e-3);
        close(measure(&grid(DVec2::new(2.0, 3.0), [4, 5])), (6.0, 0.0), 1e-6);
        close(measure(&disc(1.0, 256)), (PI, 0.0), 1e-3);
        let corners = [(0.0, 0.0, 1.0), (2.0, 0.0, 1.0), (2.0, 3.0, 1.0), (0.0, 3.0, 1.0)];
        let flat = quad(corners.map(DVec3::from));
        close(measure(&flat), (6.0, 2.0), 1e-6);
        assert_eq!(flat.normals[0], Vec3::Z);
        let mut room = cuboid(DVec3::ZERO, DVec3::ONE);
        turn_inside_out(&mut room);
        close(measure(&room), (6.0, -1.0), 1e-6);
        assert_eq!(sphere(1.0, 8).triangles.len(), 8 * (2 * 2 + 2));
    }

    /// uv (0,0) is a picture's top left.
    #[test]
    fn pictures_are_upright() {
        let mesh = grid(DVec2::ONE, [1, 1]);
        let corner = (0..4).find(|i| mesh.uvs[*i] == Vec2::ZERO).map(|i| mesh.positions[i]);
        assert_eq!(corner, Some(Vec3::new(-0.5, 0.0, -0.5)));
    }
}
