//! World-space triangles and bounds.

use glam::{DMat3, DVec3};

use crate::{Geometry, Instance, Mesh, Scene, vertex};

impl Geometry {
    /// Flattens a scene's instances: in their order those that don't move, then those that may.
    ///
    /// Positions are transformed in `f64` and rounded once, after `origin` is taken off; an origin near the
    /// scene's centre keeps them sharp. Normals go by the cofactor matrix, which is the inverse transpose
    /// where there is one and still right where an instance is flattened by a zero scale.
    pub fn new(scene: &Scene, origin: DVec3) -> Geometry {
        let mut geometry = Geometry { origin, ..Geometry::default() };
        geometry.push_all(scene, false);
        geometry.push_all(scene, true);
        geometry
    }

    /// Flattens the instances that may move only: the end of what [`Geometry::new`] gives, with indices of its own.
    pub fn moving(scene: &Scene, origin: DVec3) -> Geometry {
        let mut geometry = Geometry { origin, ..Geometry::default() };
        geometry.push_all(scene, true);
        geometry
    }

    fn push_all(&mut self, scene: &Scene, moving: bool) {
        for instance in scene.instances.iter().filter(|instance| instance.moving == moving) {
            self.push(instance, &scene.meshes[instance.mesh]);
        }
    }

    fn push(&mut self, instance: &Instance, mesh: &Mesh) {
        let matrix = instance.transform.matrix3;
        let sign = if matrix.determinant() < 0.0 { -1.0 } else { 1.0 };
        let to_normal = cofactor(matrix) * sign;
        let first = self.positions.len();

        let positions = mesh.positions.iter();
        let place =
            |p: &glam::Vec3| (instance.transform.transform_point3(p.as_dvec3()) - self.origin).as_vec3();
        let positions: Vec<_> = positions.map(place).collect();
        let triangles: Vec<_> =
            mesh.triangles.iter().map(|&[a, b, c]| if sign < 0.0 { [a, c, b] } else { [a, b, c] }).collect();
        let turn = |n: &glam::Vec3| (to_normal * n.as_dvec3()).normalize_or_zero().as_vec3();
        let mut normals: Vec<_> = mesh.normals.iter().map(turn).collect();
        vertex::unit_normals(&positions, &triangles, &mut normals);
        // The bitangent is sign · normal × tangent, and mirroring turns a cross product round.
        let turn = |t: &glam::Vec4| {
            let along = (matrix * t.truncate().as_dvec3()).normalize_or_zero().as_vec3();
            along.extend(t.w * sign as f32)
        };
        let mut tangents: Vec<_> = mesh.tangents.iter().map(turn).collect();
        vertex::unit_tangents(&normals, &mut tangents);

        self.materials.extend(std::iter::repeat_n(mesh.material as u32, positions.len()));
        self.positions.extend(positions);
        self.normals.extend(normals);
        self.tangents.extend(tangents);
        self.uvs.extend(&mesh.uvs);
        self.triangles.extend(triangles.iter().map(|t| t.map(|i| i + first as u32)));
    }
}

/// det(M) · M⁻ᵀ.
fn cofactor(DMat3 { x_axis: x, y_axis: y, z_axis: z }: DMat3) -> DMat3 {
    DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y))
}

impl Scene {
    /// The least box around all triangles, in the world; `None` if there are none.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let boxes = self.instances.iter().filter_map(|i| i.bounds(&self.meshes[i.mesh]));
        boxes.reduce(|(low, high), (l, h)| (low.min(l), high.max(h)))
    }
}

impl Instance {
    /// The least box around the triangles of its mesh, in the world.
    pub(crate) fn bounds(&self, mesh: &Mesh) -> Option<(DVec3, DVec3)> {
        let corners = mesh.triangles.iter().flatten().map(|i| mesh.positions[*i as usize].as_dvec3());
        let world = corners.map(|p| self.transform.transform_point3(p));
        world.map(|p| (p, p)).reduce(|(low, high), (p, _)| (low.min(p), high.max(p)))
    }
}
