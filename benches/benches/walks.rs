//! Rays a second through a bitmask, by walk, length and density, on one device in one run:
//! `cargo bench -p voxlume-benches --bench walks`.
//!
//! `-- N` takes another resolution than 128. Cells are met whole: what a voxel's sheets cost comes on top, for all walks.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use glam::{DVec3, UVec3};
use voxlume::Library;
use voxlume_tests::{Bits, Random, Ray, gpu};

const RAYS: usize = 1 << 18;
const RUNS: usize = 5;
const WALKS: [&str; 3] = ["leaps", "bricks", "columns"];

fn main() {
    let resolution: u32 = std::env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(128);
    println!(
        "{}, {resolution}³, {RAYS} rays, medians of {RUNS} alternating runs after one of warm-up, million rays a second\n",
        gpu().info.name
    );
    println!("| cells | rays up to | {} |", WALKS.join(" | "));
    println!("|---|---|{}", "---|".repeat(WALKS.len()));
    let mut random = Random::new(11);
    for (name, bits) in worlds(resolution, &mut random) {
        for (length, reach) in [("8 voxels", 8.0), ("32 voxels", 32.0), ("the end", 1e30)] {
            let rays = rays(resolution, reach, &mut random);
            let speeds = speeds(&bits, &rays).map(|speed| format!("{speed:.1}"));
            println!("| {name} | {length} | {} |", speeds.join(" | "));
        }
    }
}

/// A shell, as a room's walls are, and cells at random.
fn worlds(resolution: u32, random: &mut Random) -> Vec<(String, Bits)> {
    let size = [resolution; 3];
    let edge = |cell: &UVec3| cell.cmpeq(UVec3::ONE).any() || cell.cmpeq(UVec3::splat(resolution - 2)).any();
    let cells = (0..resolution.pow(3))
        .map(|i| UVec3::new(i % resolution, i / resolution % resolution, i / (resolution * resolution)));
    let mut worlds = vec![("walls of a room".to_owned(), Bits::new(size, cells.filter(edge).collect()))];
    for percent in [0.1, 1.0, 10.0] {
        worlds.push((format!("{percent} % at random"), Bits::random(size, percent, random)));
    }
    worlds
}

/// From anywhere within, in any direction.
fn rays(resolution: u32, reach: f32, random: &mut Random) -> Vec<Ray> {
    let ray = |_| {
        let origin = random.point(2.0, f64::from(resolution) - 2.0);
        let direction = loop {
            let v = random.point(-1.0, 1.0);
            if (0.01..1.0).contains(&v.length_squared()) {
                break DVec3::normalize(v);
            }
        };
        Ray { origin: origin.as_vec3(), direction: direction.as_vec3(), reach }
    };
    (0..RAYS).map(ray).collect()
}

/// Million rays a second of each walk.
fn speeds(bits: &Bits, rays: &[Ray]) -> [f64; WALKS.len()] {
    let library = Library::builtin();
    let kernels = WALKS.map(|walk| bits.kernel(&library, &format!("walk/{walk}"), rays));
    let groups = rays.len().div_ceil(64) as u32;
    let mut times = WALKS.map(|_| Vec::new());
    for run in 0..=RUNS {
        for (kernel, times) in kernels.iter().zip(&mut times) {
            let seconds = kernel.run(groups);
            if run > 0 {
                times.push(seconds);
            }
        }
    }
    times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        rays.len() as f64 / times[RUNS / 2] / 1e6
    })
}
