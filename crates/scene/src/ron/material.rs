//! `materials`.

use glam::Vec4;
use voxlume_fault::Faults;
use voxlume_fault::ron::{FromRon, Node};

use super::value::{self, Colour};
use crate::{Material, rule};

pub(super) fn read(node: Node<'_>, faults: &mut Faults) -> Vec<Material> {
    let mut materials: Vec<Material> = Vec::new();
    for (key, value) in faults.gather(node.entries()).unwrap_or_default() {
        let Some(name) = faults.gather(key.get::<String>()) else { continue };
        // A faulty material still has a name that objects may use.
        let material = faults.gather(material(value)).flatten().unwrap_or_default();
        if materials.iter().any(|known| known.name == name) {
            faults.push(key.fault(format!("material `{name}` given twice"), "the second"));
        } else {
            materials.push(Material { name, ..material });
        }
    }
    materials
}

/// `None` only with a fault.
fn material(node: Node<'_>) -> Result<Option<Material>, Faults> {
    let mut faults = Faults::default();
    let mut fields = value::unnamed(node)?;
    let grey = Rgba(Vec4::new(0.8, 0.8, 0.8, 1.0));
    let (good, range) = rule::REFLECTANCE;
    let reflectance = (|v: Rgba| good(v.0), range);
    let base_color = value::checked(&mut fields, "base_color", Some(grey), reflectance, &mut faults);
    let metallic = value::checked(&mut fields, "metallic", Some(0.0), rule::SHARE, &mut faults);
    let roughness = value::checked(&mut fields, "roughness", Some(1.0), rule::SHARE, &mut faults);
    let emission = value::colour(&mut fields, "emission", Some(0.0), &mut faults);
    let masked = fields.node("alpha_cutoff").is_some();
    let cutoff = value::checked(&mut fields, "alpha_cutoff", Some(0.0), rule::SIZE, &mut faults);
    let double_sided = fields.or("double_sided", false, &mut faults);
    fields.finish(&mut faults);
    let material = || {
        Some(Material {
            base_color: base_color?.0,
            metallic: metallic?,
            roughness: roughness?,
            emission: emission?,
            alpha_cutoff: cutoff.filter(|_| masked),
            double_sided,
            ..Material::default()
        })
    };
    faults.into_result(material())
}

/// A colour, or four parts with alpha.
#[derive(Clone, Copy)]
struct Rgba(Vec4);

impl FromRon for Rgba {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        match node.items().map_or(0, |items| items.len()) {
            4 => Ok(Rgba(node.get::<[f32; 4]>()?.into())),
            _ => Ok(Rgba(node.get::<Colour>()?.0.extend(1.0))),
        }
    }
}
