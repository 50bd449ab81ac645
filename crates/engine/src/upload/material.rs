//! Materials, as `struct Material` in wgsl/common/material.wgsl.

use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec4};
use voxlume_scene::{Scene, TextureRef};

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Material {
    pub(super) base_color: Vec4,
    pub(super) emission: Vec3,
    pub(super) alpha_cutoff: f32,
    pub(super) metallic: f32,
    pub(super) roughness: f32,
    pub(super) normal_scale: f32,
    pub(super) double_sided: u32,
    pub(super) base_color_layer: i32,
    pub(super) metallic_roughness_layer: i32,
    pub(super) normal_layer: i32,
    pub(super) emission_layer: i32,
}

/// `layers` gives each texture's layer in the array of its class, colour or data.
pub(crate) fn materials(scene: &Scene, layers: &[i32]) -> Vec<Material> {
    let layer = |texture: Option<TextureRef>| texture.map_or(-1, |texture| layers[texture.texture]);
    let convert = |m: &voxlume_scene::Material| Material {
        base_color: m.base_color,
        emission: m.emission,
        alpha_cutoff: m.alpha_cutoff.unwrap_or(0.0),
        metallic: m.metallic,
        roughness: m.roughness,
        normal_scale: m.normal_scale,
        double_sided: u32::from(m.double_sided),
        base_color_layer: layer(m.base_color_texture),
        metallic_roughness_layer: layer(m.metallic_roughness_texture),
        normal_layer: layer(m.normal_texture),
        emission_layer: layer(m.emission_texture),
    };
    let mut list: Vec<Material> = scene.materials.iter().map(convert).collect();
    if list.is_empty() {
        // A storage buffer holds at least one element.
        list.push(convert(&voxlume_scene::Material::default()));
    }
    list
}
