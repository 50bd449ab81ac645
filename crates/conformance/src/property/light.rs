//! How light is kept, added and turned.

use glam::DVec4;
use voxlume::{Numbers, Property};

use super::{all_round, check, largest, radiance_rounding, rounding};
use crate::{Bench, Check, Content, Error, Probe, Symmetry, are_bytes};

/// Radiance over the sphere and all cells, times the face of a cell, at each level: what all cells send into a
/// direction together, were none behind another.
fn sent(bench: &mut Bench<'_>, content: &Content) -> Result<Vec<f64>, Error> {
    let mut sums = Vec::new();
    for level in 0..bench.levels() {
        let probes = all_round(bench, level, 64);
        let sum: f64 = bench.run(content, &probes)?.iter().map(|value| value.truncate().element_sum()).sum();
        sums.push(sum * f64::from(level * 2).exp2());
    }
    Ok(sums)
}

/// Energy over the sphere is kept by mipmapping. A wall one voxel thick loses nothing; in a haze of opacities up to α,
/// 2ˡ voxels one behind the other hide at most (2ˡ − 1)·α/2 of each other at level l.
pub fn energy(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let alpha = 1.0 / 512.0;
    let side = bench.side();
    let mut checks = Vec::new();
    for (name, content, hidden) in [
        ("wall", Content::wall(side, 0, 2, true, glam::DVec3::ONE), 0.0),
        ("haze", Content::random(side, 31, alpha), alpha),
    ] {
        if are_bytes(bench.encoding, Numbers::Radiance) && hidden > 0.0 {
            // Thinner than a byte's step: nothing of it is there.
            continue;
        }
        let sums = sent(bench, &content)?;
        for (level, sum) in sums.iter().enumerate() {
            let layers = (level.max(1) as f64).exp2() - 1.0;
            let bound = rounding(bench, level as u32) + hidden * layers / 2.0;
            let at = format!("{name}, level {level}");
            checks.push(check(Property::Energy, at, (sum / sums[1] - 1.0).abs(), bound));
        }
    }
    Ok(checks)
}

/// The same places and levels in both contents and in their sum.
fn everywhere(bench: &Bench<'_>) -> Vec<Probe> {
    (0..bench.levels()).flat_map(|level| all_round(bench, level, 11)).collect()
}

/// What is seen of a sum of radiances is the sum.
pub fn linear(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let probes = everywhere(bench);
    let sum = Content::random(bench.side(), 41, 1.0);
    let part = |share: f64, swap: bool| {
        let mut content = sum.clone();
        for voxel in &mut content.voxels {
            let other = voxel.radiance.map(|value| (value * 1e3).fract());
            let first = voxel.radiance * other * share;
            voxel.radiance = if swap { voxel.radiance - first } else { first };
        }
        content
    };
    let whole = bench.run(&sum, &probes)?;
    let parts = [bench.run(&part(0.9, false), &probes)?, bench.run(&part(0.9, true), &probes)?];
    let miss = |i: usize| (parts[0][i] + parts[1][i] - whole[i]).truncate().abs().max_element();
    by_level(bench, Property::Linear, &probes, miss, radiance_rounding)
}

/// The 48 symmetries of the cube.
pub fn symmetric(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let probes = everywhere(bench);
    let content = Content::random(bench.side(), 51, 1.0);
    let plain: Vec<DVec4> = bench.run(&content, &probes)?;
    let mut miss = vec![0.0; probes.len()];
    for symmetry in Symmetry::all() {
        let turned: Vec<Probe> = probes.iter().map(|probe| symmetry.probe(probe)).collect();
        for (i, value) in bench.run(&symmetry.content(&content), &turned)?.iter().enumerate() {
            miss[i] = largest([miss[i], (*value - plain[i]).abs().max_element()]);
        }
    }
    by_level(bench, Property::Symmetric, &probes, |i| miss[i], rounding)
}

/// Two results with their own rounding are compared: twice the bound.
fn by_level(
    bench: &Bench<'_>,
    property: Property,
    probes: &[Probe],
    miss: impl Fn(usize) -> f64,
    rounding: fn(&Bench<'_>, u32) -> f64,
) -> Result<Vec<Check>, Error> {
    let of = |level: u32| {
        let here = (0..probes.len()).filter(|i| probes[*i].level == f64::from(level));
        check(property, format!("level {level}"), largest(here.map(&miss)), 2.0 * rounding(bench, level))
    };
    Ok((0..bench.levels()).map(of).collect())
}
