//! Cones at small angles to surfaces.

use glam::DVec3;
use voxlume::Scene;
use voxlume::scene::LightKind;

use super::{Figure, Figures};
use crate::stability::bench::Bench;

/// Share of a sun's light that a sealed box lets onto its floor, over the sun's height.
pub fn through_wall(bench: &Bench<'_>, scene: &Scene) -> Figures {
    over_heights(bench, scene, "leak", |visible| visible, |_| true, 0.01)
}

/// Share of a sun's light that a plain keeps from itself, over the sun's height.
pub fn own_shadow(bench: &Bench<'_>, scene: &Scene) -> Figures {
    over_heights(bench, scene, "own shadow", |visible| 1.0 - visible, |height| height >= 10.0, 0.02)
}

/// Degrees over the horizon.
const HEIGHTS: [f64; 6] = [60.0, 30.0, 10.0, 5.0, 2.0, 1.0];

fn over_heights(
    bench: &Bench<'_>,
    scene: &Scene,
    what: &str,
    value: fn(f64) -> f64,
    bounded: fn(f64) -> bool,
    bound: f64,
) -> Figures {
    let figure = |height: f64| {
        let mut scene = scene.clone();
        if let Some(LightKind::Directional { direction, .. }) =
            scene.lights.first_mut().map(|light| &mut light.kind)
        {
            let (sine, cosine) = height.to_radians().sin_cos();
            // Askew, so that cones run along no axis.
            *direction = DVec3::new(-0.8 * cosine, -sine, -0.6 * cosine).as_vec3();
        }
        let image = bench.image(&scene, "shadow", &[])?;
        let visible =
            image.pixels.iter().map(|pixel| f64::from(pixel[0])).sum::<f64>() / image.pixels.len() as f64;
        Ok(Figure::swept(what, "sun, °", height, value(visible), bounded(height).then_some(bound)))
    };
    HEIGHTS.into_iter().map(figure).collect()
}
