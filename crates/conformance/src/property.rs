//! The properties, each measured on the device through `voxel_sample` alone, so that any format can be.

mod light;
mod safety;
mod shape;

use glam::UVec3;
use voxlume::{Numbers, Property};

use crate::{Bench, Check, Error, Probe, Report, absolute_rounding, directions, relative_rounding};

/// Measures all of them.
pub(crate) fn measure(bench: &mut Bench<'_>, report: &mut Report) -> Result<(), Error> {
    report.extend(shape::constant(bench)?);
    report.extend(shape::opaque(bench)?);
    report.extend(shape::sides(bench)?);
    report.extend(light::energy(bench)?);
    report.extend(light::linear(bench)?);
    report.extend(light::symmetric(bench)?);
    report.extend(safety::finite(bench)?);
    report.extend(safety::repeatable(bench)?);
    Ok(())
}

/// What rounding explains at a level, over a radiance of 1: each level up to there rounds once, radiance and the opacity
/// that it is divided by.
fn rounding(bench: &Bench<'_>, level: u32) -> f64 {
    rounding_of(bench, level, bench.numbers())
}

/// What rounding of radiance explains, where opacities are the same.
fn radiance_rounding(bench: &Bench<'_>, level: u32) -> f64 {
    rounding_of(bench, level, bench.numbers().filter(|numbers| *numbers != Numbers::Coverage))
}

fn rounding_of(bench: &Bench<'_>, level: u32, numbers: impl Iterator<Item = Numbers>) -> f64 {
    let step = numbers.map(|numbers| {
        relative_rounding(bench.encoding, numbers) + absolute_rounding(bench.encoding, numbers).max_element()
    });
    2.0 * f64::from(level + 1) * largest(step)
}

fn check(property: Property, at: impl Into<String>, figure: f64, bound: f64) -> Check {
    Check { property, at: at.into(), figure, bound }
}

/// The largest; NaN if any is.
fn largest(figures: impl IntoIterator<Item = f64>) -> f64 {
    figures.into_iter().fold(0.0, |most, figure| if figure <= most { most } else { figure })
}

fn cells(size: u32) -> impl Iterator<Item = UVec3> {
    (0..size.pow(3)).map(move |i| UVec3::new(i % size, i / size % size, i / (size * size)))
}

/// Every cell of a level from `count` directions.
fn all_round(bench: &Bench<'_>, level: u32, count: usize) -> Vec<Probe> {
    let (side, directions) = (bench.side(), directions(count));
    let of = |cell| directions.iter().map(move |direction| Probe::at(cell, level, side, *direction));
    cells(side >> level).flat_map(of).collect()
}
