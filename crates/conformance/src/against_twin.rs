//! The WGSL against its twin in `f64`. Each level is worked out from the device's own level below, so that every
//! number is rounded once between the two and nothing adds up.

use glam::{DVec3, DVec4, UVec3};
use voxlume::twin::{Twin, Volumes, children};
use voxlume::{Numbers, Property};

use crate::content::Random;
use crate::substrate::opacity;
use crate::{
    Bench, Check, Content, Error, Probe, absolute_rounding, are_bytes, clamped, directions, relative_rounding,
};

/// 32 operations in `f32`, each right to 2⁻²⁴, on terms up to 8 children's: 2⁻¹⁶.
const ARITHMETIC: f64 = 1.0 / 65536.0;

/// Holds a format against a twin over one content. Figures are differences over their bounds.
///
/// # Errors
/// The device fails.
pub fn against_twin(
    bench: &mut Bench<'_>,
    twin: &dyn Twin,
    name: &str,
    content: &Content,
) -> Result<Vec<Check>, Error> {
    let (exact, between) = probes(bench);
    let values = bench.run(content, &[exact.as_slice(), &between].concat())?;
    let device = bench.volumes(content)?;
    let check = |what: &str, figure| Check {
        property: Property::Twin,
        at: format!("{name}, {what}"),
        figure,
        bound: 1.0,
    };
    let (exact_values, between_values) = values.split_at(exact.len());
    let brightest = content.voxels.iter().map(|v| v.radiance.max_element()).fold(0.0, f64::max);
    Ok(vec![
        check("store", store(bench, twin, content, &device)),
        check("mipmap", mipmap(bench, twin, content, &device)),
        check(
            "sample at cells",
            largest(exact.iter().zip(exact_values).map(|(probe, value)| {
                let expected = twin.voxel_sample(&device, probe.uvw, probe.level, probe.direction);
                over(bench, expected - *value, brightest)
            })),
        ),
        check(
            "sample between",
            largest(
                between
                    .iter()
                    .zip(between_values)
                    .map(|(probe, value)| sample_between(bench, twin, &device, probe, *value, brightest)),
            ),
        ),
    ])
}

/// NaN stays.
fn largest(figures: impl IntoIterator<Item = f64>) -> f64 {
    figures.into_iter().fold(0.0, |most, figure| if figure <= most { most } else { figure })
}

/// A sample's difference over its bound. Divisions magnify what is lost in terms as large as the brightest radiance.
/// Devices may filter bytes in bytes: half a step for each of seven interpolations, of up to three sides at √3 in all.
fn over(bench: &Bench<'_>, difference: DVec4, brightest: f64) -> f64 {
    let scale = DVec4::splat(brightest).with_w(1.0);
    let bytes = bench.numbers().filter(|numbers| are_bytes(bench.encoding, *numbers));
    let step = |numbers| match numbers {
        // Of opacities, which radiance is shared out by.
        Numbers::Coverage => absolute_rounding(bench.encoding, numbers) * scale,
        _ => absolute_rounding(bench.encoding, Numbers::Radiance),
    };
    let filtered = 6.1 * bytes.map(step).fold(DVec4::splat(f64::MIN_POSITIVE), DVec4::max);
    let bound = 16.0 * ARITHMETIC * scale + filtered;
    (difference.abs() / bound).max_element()
}

fn store(bench: &Bench<'_>, twin: &dyn Twin, content: &Content, device: &Volumes) -> f64 {
    let mut expected = Volumes { surfaces: device.surfaces.clone(), ..bench.empty() };
    for voxel in &content.voxels {
        // What the device is given is in f32.
        let given = |v: f64| f64::from(v as f32);
        let normal = device.surface(voxel.cell).map_or(DVec3::ZERO, |surface| surface.normal);
        twin.voxel_store(&mut expected, voxel.cell, voxel.radiance.map(given), normal, opacity(voxel));
    }
    differences(bench, &expected, device, 0, |_| 0.0)
}

fn mipmap(bench: &Bench<'_>, twin: &dyn Twin, content: &Content, device: &Volumes) -> f64 {
    largest((1..device.levels()).map(|level| {
        let mut expected = device.clone();
        let mut cells: Vec<UVec3> = content.voxels.iter().map(|voxel| voxel.cell >> level).collect();
        cells.sort_by_key(|cell| cell.to_array());
        cells.dedup();
        for cell in cells {
            twin.voxel_mipmap(&mut expected, cell, level);
        }
        differences(bench, &expected, device, level, |cell| {
            // The largest number among the children.
            let below = device
                .volumes
                .iter()
                .enumerate()
                .filter(|(_, (volume, _))| volume.has_level(level - 1, [device.side; 3]));
            let loads = below.flat_map(|(index, (volume, _))| {
                let texels = device.level(index, level - 1);
                let depth = texels.size.z / volume.blocks;
                let blocks = (0..volume.blocks).map(move |block| UVec3::Z * (block * depth));
                blocks.flat_map(move |block| children(cell).map(|child| texels.load(child + block)))
            });
            loads.map(|value| value.abs().max_element()).fold(0.0, f64::max)
        })
    }))
}

/// Largest difference of a level over its bound; `terms` is the largest number that a cell is worked out from.
fn differences(
    bench: &Bench<'_>,
    expected: &Volumes,
    device: &Volumes,
    level: u32,
    terms: impl Fn(UVec3) -> f64,
) -> f64 {
    let held = expected.volumes.iter().enumerate().filter(|(_, (v, _))| v.has_level(level, [device.side; 3]));
    largest(held.flat_map(|(index, (volume, _))| {
        let (a, b) = (expected.level(index, level), device.level(index, level));
        let size = a.size;
        let depth = size.z / volume.blocks;
        let terms = &terms;
        a.values.iter().zip(&b.values).enumerate().map(move |(i, (a, b))| {
            let i = i as u32;
            let texel = UVec3::new(i % size.x, i / size.x % size.y, i / (size.x * size.y) % depth);
            let a = clamped(bench.encoding, volume.numbers, *a);
            let lost = ARITHMETIC * terms(texel) + absolute_rounding(bench.encoding, volume.numbers);
            let bound = a.abs() * (relative_rounding(bench.encoding, volume.numbers) + ARITHMETIC) + lost;
            ((a - *b).abs() / bound).max_element()
        })
    }))
}

/// Hardware picks filter weights in steps of 2⁻⁸ at the coarsest that WebGPU's devices have, so a sample is what exact
/// filtering gives within so much of a texel and of a level.
fn sample_between(
    bench: &Bench<'_>,
    twin: &dyn Twin,
    device: &Volumes,
    probe: &Probe,
    value: DVec4,
    brightest: f64,
) -> f64 {
    const STEP: f64 = 1.0 / 256.0;
    let texel = probe.level.floor().exp2() / f64::from(device.side);
    let mut low = DVec4::INFINITY;
    let mut high = DVec4::NEG_INFINITY;
    for i in 0..81 {
        let offset = |place: i32| f64::from(i / place % 3 - 1) * STEP;
        let uvw = probe.uvw + DVec3::new(offset(1), offset(3), offset(9)) * texel;
        let level = (probe.level + offset(27)).clamp(0.0, f64::from(device.levels() - 1));
        let near = twin.voxel_sample(device, uvw, level, probe.direction);
        (low, high) = (low.min(near), high.max(near));
    }
    // As much again, since each of a format's fetches is on its own.
    let slack = high - low;
    let outside = (low - slack - value).max(value - high - slack).max(DVec4::ZERO);
    if value.is_finite() { over(bench, outside, brightest) } else { f64::NAN }
}

/// Cells' middles on whole levels, where filters give a texel as it is; and any places and levels.
fn probes(bench: &Bench<'_>) -> (Vec<Probe>, Vec<Probe>) {
    let side = bench.side();
    let directions = directions(13);
    let mut exact = Vec::new();
    for level in 0..bench.levels() {
        let size = side >> level;
        for i in 0..size.pow(3) {
            let cell = UVec3::new(i % size, i / size % size, i / (size * size));
            exact.push(Probe::at(cell, level, side, directions[i as usize % directions.len()]));
        }
    }
    let mut random = Random(11);
    let last = f64::from(bench.levels() - 1);
    let between = (0..400).map(|_| Probe {
        uvw: random.vector(),
        level: random.next() * last,
        direction: random.direction(),
    });
    (exact, between.collect())
}
