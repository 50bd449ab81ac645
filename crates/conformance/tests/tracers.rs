//! Every built-in tracer is measured by the suite, and held to what it is known to miss.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{CONES, Gpu, RAYS, Registry, SixFace, StorageFormat};
use voxlume_conformance::run_tracer;

/// At most so far off: open, hidden, sealed, furnace, symmetries. Rays miss as much as their directions do: 48 for openness, of
/// which one counts 0.021, and 192 for irradiance; and of a furnace the rounding of 8 bits. Cones are held to 1.2 times what was
/// measured: the book's page on stability says why.
const LIMITS: [(&str, [f64; 5]); 2] =
    [(RAYS.name, [0.001, 0.03, 0.001, 0.004, 0.025]), (CONES.name, [0.001, 0.37, 0.36, 0.16, 0.01])];

#[test]
fn every_builtin_tracer_keeps_to_its_limits() {
    let gpu = Gpu::open(None).unwrap();
    let registry = Registry::builtin();
    assert_eq!(registry.tracers.iter().count(), LIMITS.len());
    let mut failures = Vec::new();
    for (tracer, limits) in LIMITS {
        println!("{tracer}");
        let figures = run_tracer(&gpu, &registry, tracer, SixFace.name()).unwrap();
        for (figure, limit) in figures.iter().zip(limits) {
            println!("  {figure} of {limit}");
            if figure.figure.is_nan() || figure.figure.abs() > limit {
                failures.push(format!("{tracer}: {figure} of {limit}"));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
