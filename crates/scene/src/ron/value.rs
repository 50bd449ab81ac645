//! Checked values of fields. Each returns `None` after a fault.

use glam::{DVec3, Vec3};
use voxlume_fault::ron::{Fields, FromRon, Node};
use voxlume_fault::{Fault, Faults, one_of, suggest};

use crate::rule::{self, Rule};

/// The fields of `(...)`, without a name before it.
pub(super) fn unnamed<'a>(node: Node<'a>) -> Result<Fields<'a>, Fault> {
    match node.name() {
        Some(name) => {
            Err(node.fault(format!("unexpected name `{name}`"), "only `(name: value, ...)` goes here"))
        }
        None => Fields::of(node),
    }
}

/// The name of `Name(...)`, which must be one of `kinds` of a `what`.
pub(super) fn kind(
    node: Node<'_>,
    what: &str,
    kinds: &'static [&'static str],
) -> Result<&'static str, Fault> {
    let Some(name) = node.name() else {
        return Err(node.fault(format!("expected a {what} `Name(...)`"), one_of(kinds.iter().copied())));
    };
    let unknown = || node.fault(format!("unknown {what} `{name}`"), suggest(name, kinds.iter().copied()));
    kinds.iter().find(|kind| **kind == name).copied().ok_or_else(unknown)
}

/// The field's node; a fault if it is missing and there is no default.
fn node<'a>(fields: &mut Fields<'a>, name: &str, has_default: bool, faults: &mut Faults) -> Option<Node<'a>> {
    if has_default { fields.node(name) } else { fields.required_node(name, faults) }
}

/// A value that must be `good`, or the default.
pub(super) fn checked<T: FromRon + Copy>(
    fields: &mut Fields<'_>,
    name: &str,
    default: Option<T>,
    rule: (impl Fn(T) -> bool, &str),
    faults: &mut Faults,
) -> Option<T> {
    let Some(node) = node(fields, name, default.is_some(), faults) else { return default };
    let value = faults.gather(node.get())?;
    let checked = rule::check(rule, &format!("`{name}`"), value);
    faults.gather(checked.map_err(|broken| node.fault(broken, ""))).map(|()| value)
}

/// An angle in degrees, which keeps to a rule in radians; in radians.
pub(super) fn angle(
    fields: &mut Fields<'_>,
    name: &str,
    default: Option<f32>,
    (good, range): Rule<f32>,
    faults: &mut Faults,
) -> Option<f32> {
    let rule = (|degrees: f32| good(degrees.to_radians()), range);
    checked(fields, name, default, rule, faults).map(f32::to_radians)
}

/// A length above 0.
pub(super) fn length(fields: &mut Fields<'_>, name: &str, default: f64, faults: &mut Faults) -> Option<f64> {
    checked(fields, name, Some(default), (|v: f64| v as f32 > 0.0, "above 0"), faults)
}

/// A linear colour of light.
pub(super) fn colour(
    fields: &mut Fields<'_>,
    name: &str,
    default: Option<f32>,
    faults: &mut Faults,
) -> Option<Vec3> {
    let (good, range) = rule::LIGHT;
    let default = default.map(|v| Colour(Vec3::splat(v)));
    checked(fields, name, default, (|v: Colour| good(v.0), range), faults).map(|colour| colour.0)
}

/// A point or vector.
pub(super) fn vector(
    fields: &mut Fields<'_>,
    name: &str,
    default: Option<DVec3>,
    faults: &mut Faults,
) -> Option<DVec3> {
    let Some(node) = node(fields, name, default.is_some(), faults) else { return default };
    faults.gather(node.get::<[f64; 3]>()).map(DVec3::from)
}

/// A direction, made unit.
pub(super) fn direction(fields: &mut Fields<'_>, name: &str, faults: &mut Faults) -> Option<Vec3> {
    let node = fields.required_node(name, faults)?;
    let unit = DVec3::from(faults.gather(node.get::<[f64; 3]>())?).try_normalize();
    let none = || Err::<DVec3, _>(node.fault(format!("`{name}` has no length"), ""));
    faults.gather(unit.map_or_else(none, Ok)).map(|unit| unit.as_vec3())
}

/// One number for all three parts, or three.
#[derive(Clone, Copy)]
pub(super) struct Colour(pub(super) Vec3);

impl FromRon for Colour {
    fn from_ron(node: Node<'_>) -> Result<Self, Faults> {
        match node.delimiter() {
            Some(_) => Ok(Colour(node.get::<[f32; 3]>()?.into())),
            None => Ok(Colour(Vec3::splat(node.get()?))),
        }
    }
}
