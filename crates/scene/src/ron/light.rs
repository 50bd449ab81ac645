//! `lights`.

use glam::Vec3;
use voxlume_fault::Faults;
use voxlume_fault::ron::{Fields, Node};

use super::{path, value};
use crate::{Light, LightKind, Path, rule};

/// `None` only with a fault.
pub(super) fn read(node: Node<'_>, index: usize) -> Result<Option<(Light, Option<Path>)>, Faults> {
    let kind = value::kind(node, "light", &["Directional", "Point", "Spot"])?;
    let mut faults = Faults::default();
    let mut fields = Fields::of(node)?;
    let name = fields.or("name", format!("light {index}"), &mut faults);
    let light = match kind {
        "Directional" => directional(&mut fields, &mut faults),
        "Point" => point(&mut fields, &mut faults),
        _ => spot(&mut fields, &mut faults),
    };
    let path = path::read(&mut fields, path::Scales::No, &mut faults);
    fields.finish(&mut faults);
    faults.into_result(light.map(|(kind, intensity)| (Light { name, kind, intensity }, path)))
}

fn directional(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<(LightKind, Vec3)> {
    let direction = value::direction(fields, "direction", faults);
    let irradiance = value::colour(fields, "irradiance", None, faults);
    let diameter = value::angle(fields, "angular_diameter_deg", Some(0.0), rule::ANGULAR_DIAMETER, faults);
    let kind = LightKind::Directional { direction: direction?, angular_diameter: diameter? };
    Some((kind, irradiance?))
}

fn point(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<(LightKind, Vec3)> {
    let position = value::vector(fields, "position", None, faults);
    let intensity = value::colour(fields, "intensity", None, faults);
    let radius = radius(fields, faults);
    Some((LightKind::Point { position: position?, radius: radius? }, intensity?))
}

fn spot(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<(LightKind, Vec3)> {
    let position = value::vector(fields, "position", None, faults);
    let direction = value::direction(fields, "direction", faults);
    let intensity = value::colour(fields, "intensity", None, faults);
    let radius = radius(fields, faults);
    let inner = fields.or("inner_deg", 0.0_f32, faults);
    let outer = fields.or("outer_deg", 45.0_f32, faults);
    let cone = rule::spot(inner.to_radians(), outer.to_radians());
    let whole = fields.whole();
    let (inner, outer) =
        faults.gather(cone.map_err(|e| whole.fault(e, "its `inner_deg` and `outer_deg`")))?;
    let kind = LightKind::Spot { position: position?, direction: direction?, radius: radius?, inner, outer };
    Some((kind, intensity?))
}

fn radius(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<f32> {
    value::checked(fields, "radius", Some(0.0), rule::SIZE, faults)
}
