//! Surfaces that emit evenly, as the polygons that area lights are sampled by.

use std::collections::HashMap;

use glam::{DVec3, Vec2, Vec3, Vec4};

use crate::{EmissivePolygon, Instance, Material, Mesh, Scene, Texture, TextureRef};

impl Scene {
    /// The triangles whose materials emit, relative to `origin`; two that lie in a plane, share an edge and
    /// make a convex quadrilateral are one polygon. Triangles without area are left out.
    ///
    /// `None` if there are more than `limit` polygons, or if a material's emission varies over it by a
    /// texture or an alpha mask.
    pub fn emissive_polygons(&self, origin: DVec3, limit: usize) -> Option<Vec<EmissivePolygon>> {
        self.emitters(origin, limit, false)
    }

    /// As [`Scene::emissive_polygons`], but where a material's emission varies each of its triangles is as many small ones, each
    /// with its mean radiance; those that send nothing are left out.
    pub fn emissive_pieces(&self, origin: DVec3, limit: usize) -> Option<Vec<EmissivePolygon>> {
        self.emitters(origin, limit, true)
    }

    fn emitters(&self, origin: DVec3, limit: usize, pieces: bool) -> Option<Vec<EmissivePolygon>> {
        let mut polygons = Vec::new();
        for instance in &self.instances {
            let mesh = &self.meshes[instance.mesh];
            let material = &self.materials[mesh.material];
            if material.emission == Vec3::ZERO {
                continue;
            }
            let polygon = |corners: &[Vec3], radiance| EmissivePolygon {
                corners: placed(instance, corners, origin),
                radiance,
                double_sided: material.double_sided,
            };
            match self.even_emission(material) {
                Some(radiance) => {
                    // A polygon takes two triangles at most. Merged as they are in the mesh, so that a pose changes no count.
                    let triangles = own_triangles(mesh, 2 * (limit - polygons.len()))?;
                    polygons.extend(merge(&triangles).iter().map(|corners| polygon(corners, radiance)));
                }
                None if !pieces => return None,
                None => {
                    own_triangles(mesh, (limit - polygons.len()) / (PIECES * PIECES))?;
                    let parts =
                        mesh.triangles.iter().flat_map(|triangle| self.pieces(mesh, material, *triangle));
                    polygons.extend(parts.map(|(corners, radiance)| polygon(&corners, radiance)));
                }
            }
            if polygons.len() > limit {
                return None;
            }
        }
        Some(polygons)
    }

    /// What a material emits everywhere alike.
    fn even_emission(&self, material: &Material) -> Option<Vec3> {
        if material.is_masked() {
            return None;
        }
        let Some(texture) = &material.emission_texture else { return Some(material.emission) };
        let texture = &self.textures[texture.texture];
        let mut texels = texture.rgba.chunks_exact(4).map(|texel| &texel[..3]);
        let first = texels.next()?;
        texels.all(|texel| texel == first).then(|| material.emission * texture.texel(0).truncate())
    }

    /// A triangle as `PIECES` × `PIECES` smaller ones, each with the mean of what a few of its points emit.
    fn pieces(&self, mesh: &Mesh, material: &Material, triangle: [u32; 3]) -> Vec<([Vec3; 3], Vec3)> {
        let [p, uv] = [0, 1].map(|which| {
            triangle.map(|i| match which {
                0 => mesh.positions[i as usize],
                _ => mesh.uvs[i as usize].extend(0.0),
            })
        });
        let at = |corners: &[Vec3; 3], i: f32, j: f32| {
            let (u, v) = (i / PIECES as f32, j / PIECES as f32);
            corners[0] + (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v
        };
        let emitted = |uv: Vec2| {
            let texel = |texture: &TextureRef| self.textures[texture.texture].nearest(uv);
            let alpha = material.base_color_texture.as_ref().map_or(1.0, |texture| texel(texture).w);
            let there = material.alpha_cutoff.is_none_or(|cutoff| alpha * material.base_color.w >= cutoff);
            let colour = material.emission_texture.as_ref().map_or(Vec4::ONE, texel).truncate();
            if there { material.emission * colour } else { Vec3::ZERO }
        };
        let mut pieces = Vec::new();
        for i in 0..PIECES {
            for j in 0..PIECES - i {
                let (x, y) = (i as f32, j as f32);
                let up = [(x, y), (x + 1.0, y), (x, y + 1.0)];
                let down = [(x + 1.0, y + 1.0), (x, y + 1.0), (x + 1.0, y)];
                for piece in [Some(up), (i + j + 1 < PIECES).then_some(down)].into_iter().flatten() {
                    let middle = piece.map(|(x, y)| (x / 3.0, y / 3.0));
                    let middle = middle.iter().fold((0.0, 0.0), |sum, at| (sum.0 + at.0, sum.1 + at.1));
                    // Its middle, and half-way from there to its corners.
                    let points = piece.map(|(x, y)| (0.5 * (x + middle.0), 0.5 * (y + middle.1)));
                    let points = points.into_iter().chain([middle]).map(|(x, y)| at(&uv, x, y).truncate());
                    let radiance = points.map(emitted).sum::<Vec3>() / 4.0;
                    let corners = piece.map(|(x, y)| at(&p, x, y));
                    if radiance != Vec3::ZERO && unit_normal(&corners) != DVec3::ZERO {
                        pieces.push((corners, radiance));
                    }
                }
            }
        }
        pieces
    }
}

/// Pieces along each side of a triangle whose emission varies.
const PIECES: usize = 8;

impl Texture {
    /// A texel, linear.
    fn texel(&self, index: usize) -> Vec4 {
        let [r, g, b, a] = std::array::from_fn(|channel| f32::from(self.rgba[4 * index + channel]) / 255.0);
        // IEC 61966-2-1.
        let linear = |v: f32| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
        if self.srgb { Vec4::new(linear(r), linear(g), linear(b), a) } else { Vec4::new(r, g, b, a) }
    }

    /// The texel that a point lies in.
    fn nearest(&self, uv: Vec2) -> Vec4 {
        let along = |at: f32, size: u32| (((at - at.floor()) * size as f32) as u32).min(size - 1) as usize;
        self.texel(along(uv.y, self.height) * self.width as usize + along(uv.x, self.width))
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
