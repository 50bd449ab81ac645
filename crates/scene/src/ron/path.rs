//! `path` of objects, lights and cameras.

use glam::DVec3;
use voxlume_fault::Faults;
use voxlume_fault::ron::{Fields, Node};

use super::{object, value};
use crate::{Key, Path};

/// What a path may do beside moving and turning.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Scales {
    Yes,
    No,
}

/// `None` without a path, and with a fault.
pub(super) fn read(fields: &mut Fields<'_>, scales: Scales, faults: &mut Faults) -> Option<Path> {
    let node = fields.node("path")?;
    let items = faults.gather(node.items())?;
    if items.is_empty() {
        faults.push(node.fault("a path without keys", "`(time: seconds, translate: (x, y, z), ...)`"));
    }
    let mut keys: Vec<(Key, DVec3)> = Vec::new();
    let mut whole = !items.is_empty();
    for item in items {
        match faults.gather(key(item, scales, keys.last())) {
            Some(Some(key)) => keys.push(key),
            _ => whole = false,
        }
    }
    whole.then(|| Path { keys: keys.into_iter().map(|(key, _)| key).collect() })
}

/// A key and its angles in degrees; `None` only with a fault.
fn key(
    node: Node<'_>,
    scales: Scales,
    before: Option<&(Key, DVec3)>,
) -> Result<Option<(Key, DVec3)>, Faults> {
    let mut faults = Faults::default();
    let mut fields = value::unnamed(node)?;
    let time: Option<f64> = fields.required("time", &mut faults);
    let scale = match scales {
        Scales::Yes => object::scale(&mut fields, &mut faults),
        Scales::No => DVec3::ONE,
    };
    let rotate = value::vector(&mut fields, "rotate_deg", Some(DVec3::ZERO), &mut faults);
    let translate = value::vector(&mut fields, "translate", Some(DVec3::ZERO), &mut faults);
    let key = time.zip(rotate).zip(translate).map(|((time, rotate), translation)| {
        (Key { time, scale, rotation: object::rotation(rotate), translation }, rotate)
    });
    if let (Some((key, angles)), Some((earlier, earlier_angles))) = (key, before) {
        if key.time <= earlier.time {
            let at = fields.node("time").unwrap_or(node);
            faults.push(at.fault("times must rise", format!("above {}", earlier.time)));
        }
        // Half a turn has no shorter way, and a whole one would be none.
        if (angles - earlier_angles).abs().max_element() >= 180.0 {
            let at = fields.node("rotate_deg").unwrap_or(node);
            faults.push(at.fault("a turn by 180° or more between two keys", "put a key in between"));
        }
    }
    let signs = before.map_or(scale, |(earlier, _)| earlier.scale).signum();
    if (scale * signs).min_element() <= 0.0 {
        let at = fields.node("scale").unwrap_or(node);
        faults.push(at.fault("`scale` must not be 0, nor pass through it", ""));
    }
    fields.finish(&mut faults);
    faults.into_result(key)
}
