//! What must not happen whatever is stored.

use glam::{DVec3, DVec4};
use voxlume::Property;

use super::{all_round, check};
use crate::content::Random;
use crate::{Bench, Check, Content, Error, Probe, Voxel};

fn probes(bench: &Bench<'_>) -> Vec<Probe> {
    let mut random = Random(61);
    let last = f64::from(bench.levels() - 1);
    let anywhere = (0..500).map(|_| Probe {
        uvw: random.vector() * 1.2 - 0.1,
        level: random.next() * last,
        direction: random.direction(),
    });
    let axes = (0..6).map(|i| if i < 3 { DVec3::AXES[i] } else { -DVec3::AXES[i - 3] });
    let along = axes.flat_map(|direction| {
        (0..bench.levels()).map(move |level| Probe {
            uvw: DVec3::splat(0.5),
            level: f64::from(level),
            direction,
        })
    });
    let centres = (0..bench.levels()).flat_map(|level| all_round(bench, level, 7));
    anywhere.chain(along).chain(centres).collect()
}

/// Finite radiance of any size, opacities at the ends of [0, 1], normals that cancel.
fn wild(side: u32) -> Vec<(&'static str, Content)> {
    let mut random = Random(71);
    let mut pick = |list: &[f64]| list[(random.next() * list.len() as f64) as usize];
    let mut wild = |brightest: &[f64], opacities: &[f64]| {
        Content::of(side, |cell| {
            let mut vector = |list: &[f64]| DVec3::new(pick(list), pick(list), pick(list));
            let radiance = vector(brightest);
            let positive = vector(&[0.0, 1e-6, 0.5, 1.0]);
            let negative = vector(&[0.0, 1e-6, 0.5, 1.0]);
            let opacity = vector(opacities).x;
            let double_sided = vector(&[0.0, 1.0]).x;
            (vector(&[0.0, 1.0]).x > 0.0).then_some(Voxel {
                cell,
                radiance,
                opacity,
                positive,
                negative,
                double_sided,
            })
        })
    };
    vec![
        ("small and large", wild(&[0.0, 1e-38, 1e-6, 1.0, 6e4], &[0.0, 1e-7, 0.5, 1.0])),
        ("beyond half floats", wild(&[0.0, 1.0, 7e4, 1e5, 3e38], &[0.0, 0.5, 1.0])),
    ]
}

/// Samples that are not finite, negative, or more than opaque.
pub fn finite(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let probes = probes(bench);
    let is_sane = |value: &DVec4| {
        let radiance = value.truncate();
        // An `f32` sum of weights may pass 1 by its last bits.
        value.is_finite() && radiance.min_element() >= 0.0 && (0.0..=1.0 + 1e-6).contains(&value.w)
    };
    let mut checks = Vec::new();
    for (name, content) in Content::adversarial(bench.side()).into_iter().chain(wild(bench.side())) {
        let wrong = bench.run(&content, &probes)?.iter().filter(|value| !is_sane(value)).count();
        checks.push(check(Property::Finite, name, wrong as f64, 0.0));
    }
    Ok(checks)
}

/// Samples whose bits differ from one run to the next, with another content in between.
pub fn repeatable(bench: &mut Bench<'_>) -> Result<Vec<Check>, Error> {
    let probes = probes(bench);
    let content = Content::random(bench.side(), 81, 1.0);
    let first = bench.run(&content, &probes)?;
    bench.run(&Content::constant(bench.side(), DVec3::ONE), &[])?;
    let second = bench.run(&content, &probes)?;
    let bits = |value: &DVec4| value.to_array().map(f64::to_bits);
    let differ = first.iter().zip(&second).filter(|(a, b)| bits(a) != bits(b)).count();
    Ok(vec![check(Property::Repeatable, "two runs", differ as f64, 0.0)])
}
