//! A convex body alone.

use voxlume::Scene;

use super::{Figure, Figures};
use crate::stability::bench::Bench;

/// What it gathers from itself: the largest irradiance of any pixel, and the mean ambient occlusion. A ray that leaves a
/// face within a tenth of a voxel of its edge may still meet the next face.
pub fn lone(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let gathered = bench.image(scene, "diffuse", &[])?;
    let irradiance = gathered.pixels.iter().map(|pixel| f64::from(pixel[0])).fold(0.0, f64::max);
    let renderer = bench.render(scene, "ao", &[])?;
    let (ao, depth) = (renderer.picture("ao")?, renderer.picture("depth")?);
    let shown: Vec<f64> = ao
        .pixels
        .iter()
        .zip(&depth.pixels)
        .filter(|(_, d)| d[0] > 0.0)
        .map(|(ao, _)| f64::from(ao[0]))
        .collect();
    let occlusion = 1.0 - shown.iter().sum::<f64>() / shown.len() as f64;
    Ok(vec![
        Figure::at_most("irradiance from itself", irradiance, 0.0),
        Figure::at_most("ambient occlusion by itself", occlusion, 0.001),
    ])
}
