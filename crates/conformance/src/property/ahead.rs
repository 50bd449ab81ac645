//! What cones see.

use glam::DVec3;
use voxlume::Property;

use super::{check, largest, rounding};
use crate::{Bench, Check, ConeProbe, Content, Error, Probe};

/// A cone that has left a bright wall which faces the way it travels, towards a dark one: two voxels behind the apex the
/// first, three ahead the second. Samples lie where `STEPPER_DOUBLING` has them, from level 1 up.
pub fn ahead(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let (side, levels) = (bench.side(), bench.levels());
    let mut bright = vec![0f64; levels as usize];
    for axis in 0..3 {
        for positive in [false, true] {
            let (behind, before, direction) = if positive { (2, 7, 1.0) } else { (5, 0, -1.0) };
            // The walls face the observer, who is behind the cone.
            let mut content = Content::wall(side, axis, behind, !positive, DVec3::ONE);
            content.voxels.extend(Content::wall(side, axis, before, !positive, DVec3::ZERO).voxels);
            let direction = DVec3::AXES[axis] * direction;
            let mut apex = DVec3::splat(0.5);
            apex[axis] = if positive { 4.5 } else { 3.5 } / f64::from(side);
            let mut found = DVec3::ZERO;
            for level in 1..levels {
                let at = 0.75f64.sqrt() * f64::from(1 << level) / f64::from(side);
                let probe = Probe { uvw: apex + at * direction, level: level.into(), direction };
                let seen = bench.run_ahead(&content, &[ConeProbe { probe, apex, behind: found }])?;
                let most = &mut bright[level as usize];
                *most = largest([*most, seen[0].value.truncate().max_element()]);
                found = seen[0].behind;
            }
        }
    }
    let to_check = |(level, figure): (usize, &f64)| {
        check(Property::Ahead, format!("level {level}"), *figure, rounding(bench, level as u32))
    };
    Ok(bright.iter().enumerate().skip(1).map(to_check).collect())
}
