//! Primitives as meshes.

use glam::{Vec2, Vec3, Vec4};
use gltf::json::Index;
use gltf::json::accessor::Accessor;
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;
use voxlume_fault::{Fault, Faults};

use super::accessor::Accessors;
use super::at;
use super::material::UvMap;
use crate::Mesh;
use crate::limit::{Budget, TRIANGLE_BYTES, VERTEX_BYTES};
use crate::vertex;

/// What a primitive's material asks of its mesh.
pub(super) struct Use {
    /// Index in the scene.
    pub(super) material: usize,
    pub(super) uvs: UvMap,
    pub(super) normal_map: bool,
}

/// Whether it is made of triangles; points and lines have no surface.
pub(super) fn is_surface(primitive: &Primitive) -> bool {
    matches!(primitive.mode, Checked::Valid(Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan))
}

/// Takes from the budget what [`read`] will allocate.
pub(super) fn reserve(
    accessors: Accessors<'_>,
    primitive: &Primitive,
    budget: &mut Budget,
) -> Result<(), Fault> {
    let vertices = attribute(primitive, Semantic::Positions).map_or(0, |index| accessors.count(index));
    let corners = primitive.indices.map_or(vertices, |index| accessors.count(index));
    let triangles = match primitive.mode {
        Checked::Valid(Mode::Triangles) => corners / 3,
        _ => corners,
    };
    // Flat normals give each triangle vertices of its own.
    let vertices = match attribute(primitive, Semantic::Normals) {
        Some(_) => vertices,
        None => triangles.saturating_mul(3),
    };
    budget.take(vertices, VERTEX_BYTES)?;
    budget.take(triangles, TRIANGLE_BYTES)
}

/// Reads a primitive of triangles.
pub(super) fn read(
    accessors: Accessors<'_>,
    place: &str,
    name: String,
    primitive: &Primitive,
    used: &Use,
) -> Result<Mesh, Faults> {
    let positions = attribute(primitive, Semantic::Positions).ok_or_else(|| at(place, "no POSITION"))?;
    let count = accessors.count(positions) as usize;
    let reader = Reader { accessors, place, primitive, count };
    let mut faults = Faults::default();

    let positions = reader.read(Semantic::Positions, "POSITION", Vec3::from_array)?.unwrap_or_default();
    let normals = faults.gather(reader.read(Semantic::Normals, "NORMAL", Vec3::from_array)).flatten();
    let tangents = faults.gather(reader.read(Semantic::Tangents, "TANGENT", Vec4::from_array)).flatten();
    let set = used.uvs.set;
    let map = |uv| used.uvs.apply(Vec2::from_array(uv));
    let uvs = faults.gather(reader.read(Semantic::TexCoords(set), &format!("TEXCOORD_{set}"), map)).flatten();
    let triangles = faults.gather(reader.triangles());
    let triangles = faults.into_result(triangles.unwrap_or_default())?;

    let uvs = uvs.unwrap_or_else(|| vec![Vec2::ZERO; count]);
    let mut mesh = Mesh { name, positions, uvs, triangles, material: used.material, ..Mesh::default() };
    // Without normals they are flat and the file's tangents are ignored: glTF 2.0 §3.7.2.1.
    let tangents = tangents.filter(|_| normals.is_some());
    match normals {
        Some(normals) => {
            mesh.normals = normals;
            vertex::unit_normals(&mesh.positions, &mesh.triangles, &mut mesh.normals);
        }
        None => vertex::flat_normals(&mut mesh),
    }
    match tangents {
        Some(tangents) => {
            mesh.tangents = tangents;
            vertex::unit_tangents(&mesh.normals, &mut mesh.tangents);
        }
        None if used.normal_map => vertex::mikktspace_tangents(&mut mesh),
        None => mesh.tangents = mesh.normals.iter().map(|normal| vertex::any_tangent(*normal)).collect(),
    }
    Ok(mesh)
}

fn attribute(primitive: &Primitive, semantic: Semantic) -> Option<Index<Accessor>> {
    primitive.attributes.get(&Checked::Valid(semantic)).copied()
}

struct Reader<'a> {
    accessors: Accessors<'a>,
    place: &'a str,
    primitive: &'a Primitive,
    /// Of vertices.
    count: usize,
}

impl Reader<'_> {
    /// An attribute's values, if it has the attribute; all finite, one per vertex.
    fn read<T: Finite, const N: usize>(
        &self,
        semantic: Semantic,
        label: &str,
        convert: impl Fn([f32; N]) -> T,
    ) -> Result<Option<Vec<T>>, Fault> {
        let Some(index) = attribute(self.primitive, semantic) else { return Ok(None) };
        let values =
            self.accessors.vectors(index).map_err(|e| at(self.place, format!("{label}: {}", e.message)))?;
        let (found, count) = (values.len(), self.count);
        if found != count {
            return Err(at(self.place, format!("{found} values of {label} for {count} vertices")));
        }
        let values: Vec<T> = values.into_iter().map(convert).collect();
        match values.iter().position(|value| !value.finite()) {
            Some(vertex) => Err(at(self.place, format!("{label} of vertex {vertex} is not finite"))),
            None => Ok(Some(values)),
        }
    }

    fn triangles(&self) -> Result<Vec<[u32; 3]>, Fault> {
        let here = |what: String| at(self.place, what);
        let indices = match self.primitive.indices {
            Some(index) => {
                self.accessors.indices(index).map_err(|e| here(format!("indices: {}", e.message)))?
            }
            None => (0..self.count as u32).collect(),
        };
        let count = self.count;
        if let Some(at) = indices.iter().position(|index| *index as usize >= count) {
            let index = indices[at];
            return Err(here(format!("index {index} at {at} is out of range: there are {count} vertices")));
        }
        match self.primitive.mode {
            Checked::Valid(Mode::TriangleStrip) => Ok(indices
                .windows(3)
                .enumerate()
                // Every other triangle is turned, so that all face the same way.
                .map(|(i, w)| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[0], w[2], w[1]] })
                .collect()),
            Checked::Valid(Mode::TriangleFan) => {
                Ok(indices.windows(2).skip(1).map(|w| [w[0], w[1], indices[0]]).collect())
            }
            _ => {
                let (triangles, rest) = indices.as_chunks();
                let total = indices.len();
                let multiple = || here(format!("{total} indices are not a multiple of 3"));
                if rest.is_empty() { Ok(triangles.to_vec()) } else { Err(multiple()) }
            }
        }
    }
}

trait Finite {
    fn finite(&self) -> bool;
}

macro_rules! finite {
    ($($type:ty)*) => { $( impl Finite for $type { fn finite(&self) -> bool { self.is_finite() } } )* };
}
finite!(Vec2 Vec3 Vec4);
