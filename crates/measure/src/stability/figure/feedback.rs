//! Light that is fed back from bounce to bounce.

use glam::{DVec3, Vec4};
use voxlume::twin::total_reflectance;
use voxlume::{Scene, Value};

use super::{Figure, Figures};
use crate::Error;
use crate::stability::bench::{Bench, grey};

/// Gain in a closed box, over its albedo.
pub fn closed(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let figure = |albedo: f64| {
        let mut scene = scene.clone();
        // What a rough dielectric reflects grows evenly with its base colour.
        let of = |base: f64| total_reflectance(DVec3::splat(base), 0.0, 1.0).x;
        let base = ((albedo - of(0.0)) / (of(1.0) - of(0.0))) as f32;
        scene
            .materials
            .iter_mut()
            .for_each(|material| material.base_color = Vec4::new(base, base, base, 1.0));
        Ok(Figure::swept("gain", "albedo", albedo, gain(bench, &scene)?, Some(0.9999)))
    };
    [0.2, 0.5, 0.9, 0.97].into_iter().map(figure).collect()
}

/// Gain as the scene is.
pub fn as_it_is(bench: &Bench<'_>, scene: &Scene) -> Figures {
    Ok(vec![Figure::at_most("gain", gain(bench, scene)?, 0.9999)])
}

/// How much more the third bounce adds than the second; later ones sink below the steps of half floats at low albedo.
fn gain(bench: &Bench<'_>, scene: &Scene) -> Result<f64, Error> {
    let mean = |bounces: f64| {
        let set = [
            ("light", "emission", Value::Word("gather".into())),
            ("bounce", "bounces", Value::Number(bounces)),
        ];
        bench.image(scene, "diffuse", &set).map(|image| grey(&image))
    };
    let [first, second, third] = [mean(1.0)?, mean(2.0)?, mean(3.0)?];
    Ok((third - second) / (second - first))
}
