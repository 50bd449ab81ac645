//! Metallic-roughness materials.

use glam::{Mat2, Vec2, Vec3, Vec4};
use gltf::json::extensions::texture::TextureTransform;
use gltf::json::material::{AlphaMode, Material as Json};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root, deserialize, texture};
use voxlume_fault::Faults;

use super::{at, image::Wanted};
use crate::{Material, TextureRef, rule};

/// How a material's textures map a mesh's coordinates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct UvMap {
    /// Which `TEXCOORD_n`.
    pub(super) set: u32,
    offset: Vec2,
    rotation: f32,
    scale: Vec2,
}

impl UvMap {
    const NONE: UvMap = UvMap { set: 0, offset: Vec2::ZERO, rotation: 0.0, scale: Vec2::ONE };

    fn new(set: u32, transform: Option<&TextureTransform>) -> UvMap {
        transform.map_or(UvMap { set, ..UvMap::NONE }, |t| UvMap {
            set: t.tex_coord.unwrap_or(set),
            offset: Vec2::from(t.offset.0),
            rotation: t.rotation.0,
            scale: Vec2::from(t.scale.0),
        })
    }

    /// KHR_texture_transform: scale, then rotate, then offset. With v downwards, its counter-clockwise
    /// is clockwise to a matrix that thinks v upwards.
    pub(super) fn apply(&self, uv: Vec2) -> Vec2 {
        Mat2::from_angle(-self.rotation) * (self.scale * uv) + self.offset
    }
}

/// A material and how it maps texture coordinates.
pub(super) fn read(root: &Root, index: usize, wanted: &mut Wanted) -> Result<(Material, UvMap), Faults> {
    let json = &root.materials[index];
    let mut faults = Faults::default();
    let mut place = format!("materials[{index}]");
    if let Some(name) = &json.name {
        place += &format!(" `{name}`");
    }
    let mut maps = Vec::new();
    let mut texture = |name: &'static str, info: Option<&texture::Info>, srgb: bool| {
        let info = info?;
        let texture = wanted.index(root, info.index, srgb)?;
        let transform = info.extensions.as_ref().and_then(|e| e.texture_transform.as_ref());
        maps.push((name, UvMap::new(info.tex_coord, transform)));
        Some(TextureRef { texture })
    };
    let pbr = &json.pbr_metallic_roughness;
    let base_color_texture = texture("baseColorTexture", pbr.base_color_texture.as_ref(), true);
    let emission_texture = texture("emissiveTexture", json.emissive_texture.as_ref(), true);
    let metallic_roughness_texture =
        texture("metallicRoughnessTexture", pbr.metallic_roughness_texture.as_ref(), false);
    let normal = json.normal_texture.as_ref();
    let normal_info = faults.gather(normal_info(json).map_err(|e| at(&place, e))).flatten();
    let normal_texture = texture("normalTexture", normal_info.as_ref(), false);

    let strength = json.extensions.as_ref().and_then(|e| e.emissive_strength.as_ref());
    let material = Material {
        name: json.name.clone().unwrap_or_else(|| format!("material {index}")),
        base_color: Vec4::from(pbr.base_color_factor.0),
        base_color_texture,
        metallic: pbr.metallic_factor.0,
        roughness: pbr.roughness_factor.0,
        metallic_roughness_texture,
        normal_texture,
        normal_scale: normal.map_or(1.0, |normal| normal.scale),
        emission: Vec3::from(json.emissive_factor.0) * strength.map_or(1.0, |s| s.emissive_strength.0),
        emission_texture,
        alpha_cutoff: alpha_cutoff(json),
        double_sided: json.double_sided,
    };
    for checked in check(&material) {
        faults.gather(checked.map_err(|broken| at(&place, broken)));
    }
    let map = agreed(&maps).map_err(|what| at(&place, what));
    let map = faults.gather(map).unwrap_or(UvMap::NONE);
    faults.into_result((material, map))
}

/// What glTF means by no material.
pub(super) fn default() -> (Material, UvMap) {
    (Material { name: "default".into(), metallic: 1.0, ..Material::default() }, UvMap::NONE)
}

/// A normal texture as any other: the JSON crate reads its transform for the others alone.
fn normal_info(json: &Json) -> Result<Option<texture::Info>, String> {
    let Some(normal) = &json.normal_texture else { return Ok(None) };
    let transform = normal.extensions.as_ref().and_then(|e| e.others.get("KHR_texture_transform"));
    let transform = transform.map(|value| deserialize::from_value(value.clone())).transpose();
    let texture_transform = transform.map_err(|e| format!("normalTexture: KHR_texture_transform: {e}"))?;
    Ok(Some(texture::Info {
        index: Index::new(normal.index.value() as u32),
        tex_coord: normal.tex_coord,
        extensions: Some(gltf::json::extensions::texture::Info { texture_transform, ..Default::default() }),
        extras: Default::default(),
    }))
}

fn alpha_cutoff(json: &Json) -> Option<f32> {
    match json.alpha_mode {
        Checked::Valid(AlphaMode::Mask) => Some(json.alpha_cutoff.map_or(0.5, |cutoff| cutoff.0)),
        Checked::Valid(AlphaMode::Blend) => Some(0.5),
        _ => None,
    }
}

fn agreed(maps: &[(&str, UvMap)]) -> Result<UvMap, String> {
    let Some(&(first, map)) = maps.first() else { return Ok(UvMap::NONE) };
    let finite = map.offset.is_finite() && map.rotation.is_finite() && map.scale.is_finite();
    match maps.iter().find(|(_, other)| *other != map) {
        _ if !finite => Err(format!("{first}: its transform is not finite")),
        Some((other, _)) => Err(format!(
            "{first} and {other} have different texture transforms or coordinate sets; they must agree"
        )),
        None => Ok(map),
    }
}

/// The factors as glTF calls them.
fn check(material: &Material) -> [Result<(), String>; 6] {
    [
        rule::check(rule::REFLECTANCE, "baseColorFactor", material.base_color),
        rule::check(rule::SHARE, "metallicFactor", material.metallic),
        rule::check(rule::SHARE, "roughnessFactor", material.roughness),
        rule::check(rule::FINITE, "normalTexture.scale", material.normal_scale),
        rule::check(rule::LIGHT, "emissiveFactor × emissiveStrength", material.emission),
        rule::check(rule::SIZE, "alphaCutoff", material.alpha_cutoff.unwrap_or_default()),
    ]
}

/// Drops masks that no texel can fail, so that nobody pays for the test.
pub(super) fn drop_idle_masks(materials: &mut [Material], textures: &[crate::Texture]) {
    for material in materials {
        let texture = material.base_color_texture.and_then(|t| textures.get(t.texture));
        let alpha =
            texture.map_or(255, |t| t.rgba.chunks_exact(4).map(|texel| texel[3]).min().unwrap_or(255));
        let lowest = material.base_color.w * f32::from(alpha) / 255.0;
        material.alpha_cutoff = material.alpha_cutoff.filter(|cutoff| lowest < *cutoff);
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// The extension's own example: the lower left quadrant of the image, rotated clockwise by 90°.
    #[test]
    fn texture_transform_is_the_extensions_example() {
        let json = r#"{"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5]}"#;
        let transform: TextureTransform = deserialize::from_str(json).unwrap();
        let map = UvMap::new(3, Some(&transform));
        assert_eq!(map.set, 3);
        // (0,0) is the image's top left: it shows the bottom left, the top right shows the quadrant's top.
        for (uv, expected) in [((0.0, 0.0), (0.0, 1.0)), ((1.0, 0.0), (0.0, 0.5)), ((0.0, 1.0), (0.5, 1.0))] {
            let found = map.apply(Vec2::from(uv));
            assert!(found.abs_diff_eq(Vec2::from(expected), 1e-6), "{uv:?}: {found}");
        }
    }
}
