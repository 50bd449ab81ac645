//! `cameras`.

use glam::DVec3;
use voxlume_fault::Faults;
use voxlume_fault::ron::Node;

use super::{path, value};
use crate::{Camera, Path, rule};

/// `None` only with a fault.
pub(super) fn read(node: Node<'_>, index: usize) -> Result<Option<(Camera, Option<Path>)>, Faults> {
    let mut faults = Faults::default();
    let mut fields = value::unnamed(node)?;
    let name = fields.or("name", format!("camera {index}"), &mut faults);
    let eye = value::vector(&mut fields, "eye", None, &mut faults);
    let target = value::vector(&mut fields, "target", None, &mut faults);
    let up = value::vector(&mut fields, "up", Some(DVec3::Y), &mut faults);
    let fov = value::angle(&mut fields, "fov_deg", None, rule::VERTICAL_FOV, &mut faults);
    let path = path::read(&mut fields, path::Scales::No, &mut faults);
    fields.finish(&mut faults);
    let camera = || {
        let camera = Camera::look_at(name, eye?, target?, up?, fov?);
        let none = || node.fault("no view: `eye` is at `target`, or `up` points along the view", "");
        faults.gather(camera.ok_or_else(none))
    };
    let camera = camera().map(|camera| (camera, path));
    faults.into_result(camera)
}
