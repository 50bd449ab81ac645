//! Irradiance against closed forms.

use std::f64::consts::PI;

use voxlume::{Scene, Value};

use super::{Figure, Figures, reflectance};
use crate::stability::bench::{Bench, grey};

/// In the closed furnace, which emits L = 1 and reflects ρ: voxels gather emission once and emit, so irradiance/π is 1 + ρ.
pub fn furnace(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let set = [("light", "emission", Value::Word("gather".into()))];
    let value = grey(&bench.image(scene, "diffuse", &set)?) / PI / (1.0 + reflectance(scene)) - 1.0;
    Ok(vec![Figure::at_most("irradiance beside the closed form", value, 0.05)])
}

/// On a convex body under a sky of 1: irradiance/π is 1. The image's background is left out.
pub fn open_sky(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let renderer = bench.render(scene, "diffuse", &[])?;
    let depth = renderer.picture("depth")?;
    let image = renderer.picture("diffuse")?;
    let hit: Vec<f64> = image
        .pixels
        .iter()
        .zip(&depth.pixels)
        .filter(|(_, d)| d[0] > 0.0)
        .map(|(p, _)| f64::from(p[0]))
        .collect();
    let value = hit.iter().sum::<f64>() / hit.len() as f64 / PI - 1.0;
    Ok(vec![Figure::at_most("irradiance beside the sky's", value, 0.03)])
}
