//! Bits that differ.

use voxlume::{Renderer, Scene};

use super::{Figure, Figures};
use crate::Error;
use crate::stability::bench::{Bench, images, volumes};

/// Between two runs: in the voxels, the volumes and every image.
pub fn runs(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let all = || {
        let renderer = bench.render(scene, "final", &[])?;
        let mut bytes = voxels(&renderer)?;
        let add = |bytes: &mut Vec<u8>, texels: &[[f32; 4]]| {
            bytes.extend(texels.iter().flatten().flat_map(|value| value.to_bits().to_le_bytes()));
        };
        for (_, _, texels) in volumes(&renderer)? {
            add(&mut bytes, &texels);
        }
        for name in images(&renderer) {
            add(&mut bytes, &renderer.picture(&name)?.pixels);
        }
        Ok::<Vec<u8>, Error>(bytes)
    };
    Ok(vec![Figure::at_most("bits of all that was computed", differing(&all()?, &all()?), 0.0)])
}

/// After shuffling instances and triangles: in the voxels.
pub fn shuffled(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let of = |scene: &Scene| voxels(&bench.render(scene, "final", &[])?);
    let mut other = scene.clone();
    other.instances.reverse();
    for mesh in &mut other.meshes {
        let count = mesh.triangles.len();
        // A stride prime to every count up to it meets each triangle once, in another order.
        let stride = (count / 2..).find(|stride| gcd(*stride, count) == 1).unwrap_or(1);
        mesh.triangles = (0..count).map(|i| mesh.triangles[i * stride % count]).collect();
    }
    Ok(vec![Figure::at_most("bits of the voxels", differing(&of(scene)?, &of(&other)?), 0.0)])
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The substrate: occupancy, ranks, the list of cells, the sums of attributes.
fn voxels(renderer: &Renderer<'_>) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    for name in ["occupancy", "ranks", "levels", "cells", "attributes"] {
        bytes.extend(renderer.buffer(name)?.unwrap_or_default());
    }
    Ok(bytes)
}

fn differing(a: &[u8], b: &[u8]) -> f64 {
    let bits: u32 = a.iter().zip(b).map(|(a, b)| (a ^ b).count_ones()).sum();
    f64::from(bits) + 8.0 * a.len().abs_diff(b.len()) as f64
}
