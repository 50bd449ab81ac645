//! What walls and full space look like.

use glam::{DVec3, DVec4};
use voxlume::Property;

use super::{check, largest, rounding};
use crate::content::Random;
use crate::{Bench, Check, Content, Error, Probe};

/// Constant in, constant out: any place, direction and level, whole or not.
pub fn constant(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let radiance = DVec3::new(0.1, 0.5, 1.0);
    let expected = radiance.extend(1.0);
    let mut random = Random(21);
    let content = Content::constant(bench.side(), radiance);
    let mut checks = Vec::new();
    for level in 0..bench.levels() {
        let mut probe = |fraction: f64| Probe {
            uvw: random.vector(),
            level: (f64::from(level) + fraction).min(f64::from(bench.levels() - 1)),
            direction: random.direction(),
        };
        let probes: Vec<Probe> = (0..200).map(|i| probe(if i % 2 == 0 { 0.0 } else { 0.3 })).collect();
        let values = bench.run(&content, &probes)?;
        let figure = largest(values.iter().map(|value| (*value - expected).abs().max_element()));
        checks.push(check(Property::Constant, format!("level {level}"), figure, rounding(bench, level + 1)));
    }
    Ok(checks)
}

/// A wall one voxel thick, at both places that it can have in its parent, seen from its front.
pub fn opaque(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let (side, levels) = (bench.side(), bench.levels());
    let mut passes = vec![0f64; levels as usize];
    for axis in 0..3 {
        for positive in [false, true] {
            for at in [2, 5] {
                let direction = if positive { -DVec3::AXES[axis] } else { DVec3::AXES[axis] };
                let (probes, of_level) = wall_probes(side, levels, axis, at, direction);
                let content = Content::wall(side, axis, at, positive, DVec3::ONE);
                for (value, level) in bench.run(&content, &probes)?.iter().zip(of_level) {
                    let most = &mut passes[level as usize];
                    *most = largest([*most, (1.0 - value.w).abs()]);
                }
            }
        }
    }
    let to_check = |(level, figure): (usize, &f64)| {
        check(Property::Opaque, format!("level {level}"), *figure, rounding(bench, level as u32))
    };
    Ok(passes.iter().enumerate().map(to_check).collect())
}

/// The cells that a wall lies in, level by level.
fn wall_probes(side: u32, levels: u32, axis: usize, at: u32, direction: DVec3) -> (Vec<Probe>, Vec<u32>) {
    let of = |level: u32| {
        super::cells(side >> level)
            .filter(move |cell| cell[axis] == at >> level)
            .map(move |cell| (Probe::at(cell, level, side, direction), level))
    };
    (0..levels).flat_map(of).unzip()
}

/// RAU figure 5.6: from its own side the red wall is red and nothing else, the green one green.
pub fn sides(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let (side, levels) = (bench.side(), bench.levels());
    let mut wrong = vec![0f64; levels as usize];
    for axis in 0..3 {
        let content = Content::red_green_wall(side, axis, 2);
        for (at, direction, colour) in [(2, 1.0, DVec3::X), (3, -1.0, DVec3::Y)] {
            let (probes, of_level) = wall_probes(side, levels, axis, at, DVec3::AXES[axis] * direction);
            let expected: DVec4 = colour.extend(1.0);
            for (value, level) in bench.run(&content, &probes)?.iter().zip(of_level) {
                let most = &mut wrong[level as usize];
                *most = largest([*most, (*value - expected).abs().max_element()]);
            }
        }
    }
    let to_check = |(level, figure): (usize, &f64)| {
        check(Property::Sides, format!("level {level}"), *figure, rounding(bench, level as u32))
    };
    Ok(wrong.iter().enumerate().map(to_check).collect())
}
