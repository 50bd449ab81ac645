//! Radiance over eleven orders of magnitude.

use voxlume::{Scene, Value};

use super::{Figure, Figures};
use crate::Error;
use crate::stability::bench::{Bench, grey};

/// What comes of an emission over that emission, beside the same for 1.
pub fn range(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let relative = |radiance: f64| {
        let mut scene = scene.clone();
        scene.materials.iter_mut().for_each(|material| material.emission *= radiance as f32);
        let set = [("light", "emission", Value::Word("gather".into()))];
        Ok::<f64, Error>(grey(&bench.image(&scene, "diffuse", &set)?) / radiance)
    };
    let one = relative(1.0)?;
    let figure = |radiance: f64| {
        let value = relative(radiance)? / one - 1.0;
        Ok(Figure::swept("irradiance beside that of 1", "radiance", radiance, value, Some(0.01)))
    };
    [1e-6, 1e-4, 1e-2, 1e2, 1e4, 1e5].into_iter().map(figure).collect()
}
