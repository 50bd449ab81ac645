//! Light that gets through sealed walls.

use std::f64::consts::PI;

use glam::{DAffine3, DVec3, Vec3, Vec4};
use voxlume::Scene;

use super::{Figure, Figures, reflectance};
use crate::stability::bench::{Bench, grey};

/// Of walls, voxels.
const THICKNESSES: [f64; 5] = [4.0, 2.0, 1.0, 0.5, 0.25];

/// Share of the sky's radiance that a sealed box lets in, over the thickness of its walls.
pub fn from_sky(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let sky = f64::from(scene.sky.element_sum()) / 3.0;
    sweep(bench, scene, "diffuse", PI * sky)
}

/// Share of the radiance of the sunlit outside that is seen inside.
pub fn from_sun(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let irradiance = scene.lights.first().map_or(0.0, |light| f64::from(light.intensity.element_sum()) / 3.0);
    sweep(bench, scene, "final", reflectance(scene) * irradiance / PI)
}

/// Share of the sky's radiance that gets through walls which reflect nothing.
pub fn through_black(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let mut scene = scene.clone();
    for material in &mut scene.materials {
        // A metal without colour: a dielectric would still reflect 4 %.
        (material.base_color, material.metallic) = (Vec4::new(0.0, 0.0, 0.0, 1.0), 1.0);
    }
    from_sky(bench, &scene)
}

/// Share of the light of a sun without size that gets in: rays of aperture 0, which keep to level 0.
pub fn at_level_0(bench: &Bench<'_>, scene: &Scene) -> Figures {
    sweep(bench, scene, "shadow", 1.0)
}

/// By how much the sky changes the light of a lamp inside walls of two voxels, over the lamp's intensity.
pub fn beside_lamp(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let figure = |intensity: f64| {
        let mut scene = with_wall(bench, scene, 2.0);
        for light in &mut scene.lights {
            light.intensity = Vec3::splat(intensity as f32);
        }
        let lit = grey(&bench.image(&scene, "diffuse", &[])?);
        scene.sky = Vec3::ZERO;
        let value = lit / grey(&bench.image(&scene, "diffuse", &[])?) - 1.0;
        let bound = bench.is_directional().then_some(0.05);
        Ok(Figure::swept("change by the sky", "W/sr", intensity, value, bound))
    };
    [6.4, 1.6, 0.4, 0.1].into_iter().map(figure).collect()
}

fn sweep(bench: &Bench<'_>, scene: &Scene, output: &str, behind: f64) -> Figures {
    let figure = |voxels: f64| {
        let image = bench.image(&with_wall(bench, scene, voxels), output, &[])?;
        let bound = if bench.is_directional() { 0.001 } else { 0.01 };
        let value = grey(&image) / behind;
        Ok(Figure::swept("leak", "wall, voxels", voxels, value, (voxels >= 1.0).then_some(bound)))
    };
    THICKNESSES.into_iter().map(figure).collect()
}

/// The scene with its `inside`, a unit cube, so large that the wall is this thick.
fn with_wall(bench: &Bench<'_>, scene: &Scene, voxels: f64) -> Scene {
    let side = 1.0 - 2.0 * voxels * f64::from(bench.grid(scene).voxel_size);
    let mut scene = scene.clone();
    if let [outside, inside] = &mut scene.instances[..] {
        inside.transform = outside.transform * DAffine3::from_scale(DVec3::splat(side));
    }
    scene
}
