//! The shapes of `objects`.

use glam::{DVec2, DVec3, Vec3};
use voxlume_fault::ron::{Fields, Node};
use voxlume_fault::{Fault, Faults};

use super::value;
use crate::{Mesh, shape};

const SHAPES: [&str; 8] = ["Box", "Quad", "Grid", "Disc", "Cylinder", "Sphere", "Triangle", "Triangles"];

/// A grid's cells at most; also triangles and positions given one by one.
const MAX_CELLS: u64 = 4_000_000;
/// A round shape's segments at most.
const MAX_SEGMENTS: u32 = 2048;

/// `None` only with a fault.
pub(super) fn read(node: Node<'_>) -> Result<Option<Mesh>, Faults> {
    let kind = value::kind(node, "shape", &SHAPES)?;
    let mut faults = Faults::default();
    let mut fields = Fields::of(node)?;
    let mesh = match kind {
        "Box" => cuboid(&mut fields, &mut faults),
        "Quad" => corners(&mut fields, &mut faults).map(shape::quad),
        "Grid" => grid(&mut fields, &mut faults),
        "Disc" => round(&mut fields, &mut faults).map(|(r, n)| shape::disc(r, n)),
        "Cylinder" => {
            let height = value::length(&mut fields, "height", 1.0, &mut faults);
            round(&mut fields, &mut faults).zip(height).map(|((r, n), height)| shape::cylinder(r, height, n))
        }
        "Sphere" => round(&mut fields, &mut faults).map(|(r, n)| shape::sphere(r, n)),
        "Triangle" => corners(&mut fields, &mut faults).map(|corners: [DVec3; 3]| {
            shape::triangles(corners.map(|c| c.as_vec3()).into(), vec![[0, 1, 2]])
        }),
        _ => triangles(&mut fields, &mut faults),
    };
    fields.finish(&mut faults);
    faults.into_result(mesh)
}

fn cuboid(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<Mesh> {
    let low = value::vector(fields, "min", Some(DVec3::splat(-0.5)), faults);
    let high = value::vector(fields, "max", Some(DVec3::splat(0.5)), faults);
    let (low, high) = low.zip(high)?;
    if low.cmpgt(high).any() {
        faults.push(fields.whole().fault("`min` must not be above `max`", ""));
    }
    Some(shape::cuboid(low, high))
}

fn corners<const N: usize>(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<[DVec3; N]> {
    let corners: [[f64; 3]; N] = fields.required("corners", faults)?;
    Some(corners.map(DVec3::from))
}

fn grid(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<Mesh> {
    let above = (|v: [f64; 2]| v.iter().all(|v| *v as f32 > 0.0), "above 0");
    let size = value::checked(fields, "size", Some([1.0; 2]), above, faults);
    let range = format!("at least 1 and together at most {MAX_CELLS}");
    let few = |v: [u32; 2]| v.iter().all(|n| *n > 0) && u64::from(v[0]) * u64::from(v[1]) <= MAX_CELLS;
    let cells = value::checked(fields, "cells", Some([1; 2]), (few, &range), faults);
    Some(shape::grid(DVec2::from(size?), cells?))
}

fn round(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<(f64, u32)> {
    let radius = value::length(fields, "radius", 0.5, faults);
    let range = format!("from 3 to {MAX_SEGMENTS}");
    let few = |v: u32| (3..=MAX_SEGMENTS).contains(&v);
    radius.zip(value::checked(fields, "segments", Some(64), (few, &range), faults))
}

fn triangles(fields: &mut Fields<'_>, faults: &mut Faults) -> Option<Mesh> {
    let positions: Option<Vec<[f32; 3]>> = fields.required("positions", faults);
    let indices = fields.required_node("indices", faults);
    let triangles: Vec<[u32; 3]> = faults.gather(indices?.get())?;
    let positions = positions?;
    let count = positions.len();
    let items = indices?.items().unwrap_or_default();
    let mut wrong = items.iter().zip(&triangles).filter(|(_, t)| t.iter().any(|i| *i as usize >= count));
    if let Some((node, _)) = wrong.next() {
        faults.push(out_of_range(*node, count));
        return None;
    }
    Some(shape::triangles(positions.into_iter().map(Vec3::from).collect(), triangles))
}

fn out_of_range(node: Node<'_>, count: usize) -> Fault {
    node.fault("index out of range", format!("there are {count} positions"))
}
