//! Cones of every aperture.

use voxlume::Scene;
use voxlume::scene::LightKind;

use super::finite::not_finite;
use super::{Figure, Figures};
use crate::stability::bench::Bench;

/// Values of the image that are not finite, or visibilities that are no share, over apertures below 180°.
pub fn aperture(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let figure = |degrees: f64| {
        let mut scene = scene.clone();
        for light in &mut scene.lights {
            let half = (degrees / 2.0).to_radians();
            match &mut light.kind {
                LightKind::Directional { angular_diameter, .. } => *angular_diameter = 2.0 * half as f32,
                // At almost 180° all that is nearer than 3 units is inside.
                LightKind::Point { radius, .. } | LightKind::Spot { radius, .. } => {
                    *radius = 3.0 * half.sin() as f32
                }
            }
        }
        let renderer = bench.render(&scene, "final", &[])?;
        let shadow = renderer.picture("shadow")?;
        let shares = shadow.pixels.iter().flatten().filter(|value| !(0.0..=1.0).contains(*value)).count();
        let wrong = not_finite(&renderer.picture("final")?) + shares;
        Ok(Figure::at_most(format!("wrong values at {degrees}°"), wrong as f64, 0.0))
    };
    [0.0, 0.001, 1.0, 30.0, 90.0, 150.0, 179.0, 179.999].into_iter().map(figure).collect()
}

/// Values of what is gathered, and of the image, that are no radiance, over roughnesses of a metal from a mirror to a lobe of
/// 137°. Images clamp what is infinite to the largest half float.
pub fn roughness(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let figure = |roughness: f32| {
        let mut scene = scene.clone();
        for material in &mut scene.materials {
            (material.metallic, material.roughness) = (1.0, roughness);
        }
        let renderer = bench.render(&scene, "final", &[])?;
        let mut wrong = 0;
        for image in ["specular", "final"] {
            let picture = renderer.picture(image)?;
            wrong += picture.pixels.iter().flatten().filter(|value| !(0.0..65504.0).contains(*value)).count();
        }
        Ok(Figure::at_most(format!("wrong values at {roughness:?}"), wrong as f64, 0.0))
    };
    [0.0, 1e-20, 1e-3, 0.1, 0.5, 0.9, 1.0].into_iter().map(figure).collect()
}
