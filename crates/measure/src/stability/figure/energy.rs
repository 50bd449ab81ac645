//! What the levels of a volume hold.

use voxlume::{Scene, Value};

use super::{Figure, Figures};
use crate::stability::bench::{Bench, volumes};

/// Along an axis of the grid: exact but for rounding.
pub fn along_an_axis(bench: &Bench<'_>, scene: &Scene) -> Figures {
    energy(bench, scene, 0.01)
}

/// Askew.
pub fn askew(bench: &Bench<'_>, scene: &Scene) -> Figures {
    energy(bench, scene, 0.1)
}

/// Σ |value| × cell face of each level over that of the volume's finest, less 1: a wall has as many cells a level as a cell
/// has faces less.
fn energy(bench: &Bench<'_>, scene: &Scene, bound: f64) -> Figures {
    let gather = [("light", "emission", Value::Word("gather".into()))];
    // It samples the volume, whatever the tracer does.
    let renderer = bench.render(scene, "voxel_view", &gather)?;
    let mut finest = 0.0;
    let mut figures = Vec::new();
    for (name, mip, texels) in volumes(&renderer)? {
        let sum: f64 = texels.iter().flat_map(|texel| &texel[..3]).map(|value| f64::from(value.abs())).sum();
        let held = sum * 4f64.powi(mip as i32);
        if mip == 0 {
            finest = held;
        } else {
            let what = format!("`{name}` beside its finest level");
            let mut figure = Figure::swept(&what, "level", f64::from(mip), held / finest - 1.0, Some(bound));
            // The topmost cell holds the whole wall and what is around it.
            figure.bound = figure.bound.filter(|_| texels.len() > 8 * 6);
            figures.push(figure);
        }
    }
    Ok(figures)
}
