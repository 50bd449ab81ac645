//! What of a scene a plan depends on.

use std::ops::Range;

use glam::DVec3;
use voxlume_fault::Faults;
use voxlume_scene::{Instance, LightKind, Material, Mesh, Scene, Texture};

use crate::live::CONDITIONS;

/// Most emissive polygons that count as area lights of their own; beyond, emission is gathered from voxels.
pub const AREA_LIGHT_LIMIT: usize = 16;

/// Most emissive polygons, pieces of textured ones among them, of which places ask a few; beyond, emission is gathered from voxels.
pub const EMITTER_LIMIT: usize = 1 << 16;

/// How what surfaces emit reaches others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Emission {
    /// Each of a few polygons is a light of its own.
    AreaLights,
    /// Each place asks a few of many polygons.
    Sampled,
    /// From voxels, if anything emits.
    Gathered,
}

/// What a scene needs, so that a plan models only that.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFacts {
    /// Lowest and highest corner, world space; `None` without triangles.
    pub bounds: Option<(DVec3, DVec3)>,
    /// Triangles of all instances.
    pub triangles: u32,
    /// Length of the longest edge of any triangle, world units.
    pub longest_edge: f64,
    /// Vertices of all instances.
    pub vertices: u32,
    /// Materials.
    pub materials: u32,
    /// Directional, point and spot lights.
    pub directional: u32,
    /// Point lights.
    pub point: u32,
    /// Spot lights.
    pub spot: u32,
    /// Planar emissive polygons; `None` where emission is not a few plain polygons.
    pub polygons: Option<u32>,
    /// Emissive polygons or pieces of such; `None` where there are too many.
    pub emitters: Option<u32>,
    /// The largest component of any material's emission, W·m⁻²·sr⁻¹.
    pub emission_max: f32,
    /// Whether any material emits.
    pub emissive: bool,
    /// Whether any material has a texture.
    pub textured: bool,
    /// Colour textures and data textures.
    pub texture_layers: [u32; 2],
    /// Side of every texture layer in texels.
    pub texture_size: u32,
    /// Whether any material has an alpha mask.
    pub masked: bool,
    /// Triangles of such materials, of instances that never move and of those that may; they come last among these.
    pub masked_triangles: [u32; 2],
    /// Whether any material is metallic or smoother than fully rough.
    pub glossy: bool,
    /// Whether any material's roughness is below 0.2, in at least a hundredth of its texture.
    pub polished: bool,
    /// Directional, point and spot lights that are [wide](SceneFacts::is_wide).
    pub wide: u32,
    /// Whether anything outside the scene shines.
    pub sky: bool,
    /// Triangles of instances that may move; they come after all others.
    pub moving_triangles: u32,
}

/// Roughness below which a material's reflections are as sharp as pixels: effect/specular.wgsl shares none of them out.
const POLISHED: f32 = 0.2;

/// Share of a texture's texels that makes its material polished: fewer are dirt and noise.
const POLISHED_SHARE: f64 = 0.01;

fn is_polished(material: &Material, textures: &[Texture]) -> bool {
    let texture = material.metallic_roughness_texture.and_then(|of| textures.get(of.texture));
    let Some(texture) = texture else { return material.roughness < POLISHED };
    // Green is what the roughness is multiplied with.
    let limit = POLISHED / material.roughness.max(f32::MIN_POSITIVE) * 255.0;
    let texels = texture.rgba.chunks_exact(4);
    let (all, polished) = (texels.len(), texels.filter(|texel| f32::from(texel[1]) < limit).count());
    polished as f64 > POLISHED_SHARE * all as f64
}

/// Largest side of a texture layer, texels.
const TEXTURE_SIZE_LIMIT: u32 = 1024;

/// Of an instance's triangles, world units.
fn longest_edge(instance: &Instance, mesh: &Mesh) -> f64 {
    let turn = instance.transform.matrix3;
    let corner = |i: u32| turn * mesh.positions[i as usize].as_dvec3();
    let squares = mesh
        .triangles
        .iter()
        .map(|t| t.map(corner))
        .map(|[a, b, c]| a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a)));
    squares.fold(0.0, f64::max).sqrt()
}

impl SceneFacts {
    /// Reads them off a scene.
    ///
    /// # Errors
    /// The faults that [`Scene::check`] finds.
    pub fn of(scene: &Scene) -> Result<SceneFacts, Faults> {
        scene.check()?;
        let meshes = || scene.instances.iter().map(|instance| &scene.meshes[instance.mesh]);
        let used: Vec<_> = {
            let mut used = vec![false; scene.materials.len()];
            meshes().for_each(|mesh| used[mesh.material] = true);
            scene.materials.iter().zip(used).filter(|(_, used)| *used).map(|(material, _)| material).collect()
        };
        let count =
            |kind: fn(&LightKind) -> bool| scene.lights.iter().filter(|l| kind(&l.kind)).count() as u32;
        let largest = scene.textures.iter().map(|t| t.width.max(t.height)).max().unwrap_or(1);
        let srgb = scene.textures.iter().filter(|texture| texture.srgb).count() as u32;
        let emissive = used.iter().any(|material| material.emission.max_element() > 0.0);
        let polygons =
            scene.emissive_polygons(DVec3::ZERO, AREA_LIGHT_LIMIT).map(|polygons| polygons.len() as u32);
        let pieces = || scene.emissive_pieces(DVec3::ZERO, EMITTER_LIMIT).map(|pieces| pieces.len() as u32);
        let emitters = polygons.or_else(pieces);
        Ok(SceneFacts {
            bounds: scene.reach(),
            triangles: meshes().map(|mesh| mesh.triangles.len() as u32).sum(),
            longest_edge: scene
                .instances
                .iter()
                .map(|i| longest_edge(i, &scene.meshes[i.mesh]))
                .fold(0.0, f64::max),
            vertices: meshes().map(|mesh| mesh.positions.len() as u32).sum(),
            materials: scene.materials.len() as u32,
            directional: count(|kind| matches!(kind, LightKind::Directional { .. })),
            point: count(|kind| matches!(kind, LightKind::Point { .. })),
            spot: count(|kind| matches!(kind, LightKind::Spot { .. })),
            polygons,
            emitters,
            emission_max: scene.materials.iter().map(|m| m.emission.max_element()).fold(0.0, f32::max),
            emissive,
            textured: used.iter().any(|material| {
                material.base_color_texture.is_some()
                    || material.metallic_roughness_texture.is_some()
                    || material.normal_texture.is_some()
                    || material.emission_texture.is_some()
            }),
            texture_layers: [srgb, scene.textures.len() as u32 - srgb],
            texture_size: largest.next_power_of_two().min(TEXTURE_SIZE_LIMIT),
            masked: used.iter().any(|material| material.is_masked()),
            masked_triangles: [false, true].map(|moving| {
                let instances = scene.instances.iter().filter(|instance| instance.moving == moving);
                let meshes = instances.map(|instance| &scene.meshes[instance.mesh]);
                let masked = meshes.filter(|mesh| scene.materials[mesh.material].is_masked());
                masked.map(|mesh| mesh.triangles.len() as u32).sum()
            }),
            glossy: used.iter().any(|material| {
                material.metallic > 0.0
                    || material.roughness < 1.0
                    || material.metallic_roughness_texture.is_some()
            }),
            polished: used.iter().any(|material| is_polished(material, &scene.textures)),
            wide: count(SceneFacts::is_wide),
            sky: scene.sky.max_element() > 0.0,
            moving_triangles: scene
                .instances
                .iter()
                .filter(|instance| instance.moving)
                .map(|instance| scene.meshes[instance.mesh].triangles.len() as u32)
                .sum(),
        })
    }

    /// How many of these triangles, all or all that never move or all that may, have an alpha mask.
    pub(crate) fn masked_in(&self, triangles: &Range<u32>) -> u32 {
        let still = self.triangles - self.moving_triangles;
        let [never, may] = self.masked_triangles;
        let never = if triangles.start < still { never } else { 0 };
        let may = if triangles.end > still { may } else { 0 };
        never + may
    }

    /// Whether a light is too wide for its shadow map to say how soft its shadows are: a sphere, or a sun of over 5.7°.
    pub fn is_wide(kind: &LightKind) -> bool {
        match kind {
            LightKind::Directional { angular_diameter, .. } => *angular_diameter > 0.1,
            LightKind::Point { radius, .. } | LightKind::Spot { radius, .. } => *radius > 0.0,
        }
    }

    /// Lights without a surface in the scene.
    pub fn punctual(&self) -> u32 {
        self.directional + self.point + self.spot
    }

    /// Whether the scene has what the word after `when` asks for.
    pub fn meets(&self, condition: &str, emission: Emission) -> bool {
        let known = CONDITIONS.iter().find(|(word, ..)| *word == condition);
        known.is_none_or(|(_, _, holds)| holds(self, emission))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The shader's limit is the same.
    #[test]
    fn what_is_polished_is_what_shares_no_reflections() {
        let wgsl = include_str!("../../../wgsl/effect/specular.wgsl");
        assert!(wgsl.contains(&format!("const SHARP = {POLISHED};")));
    }
}
