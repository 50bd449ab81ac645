//! The same scene elsewhere, of another size, mirrored or turned.

use glam::{DAffine3, DQuat, DVec3, EulerRot};
use voxlume::scene::LightKind;
use voxlume::{Picture, Scene};

use super::{Figure, Figures};
use crate::stability::bench::{Bench, difference, grey};

/// Difference of the image, moved away along each axis.
pub fn origin(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let here = bench.image(scene, "final", &[])?;
    let figure = |distance: f64| {
        let away = DAffine3::from_translation(DVec3::new(distance, -distance, distance));
        let there = bench.image(&transformed(scene, away), "final", &[])?;
        Ok(Figure::swept("difference", "distance, units", distance, difference(&here, &there), Some(0.005)))
    };
    [1e2, 1e3, 1e4, 1e5, 1e6].into_iter().map(figure).collect()
}

/// Difference of the image, by the scene's width.
pub fn scale(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let here = bench.image(scene, "final", &[])?;
    let width = scene.bounds().map_or(1.0, |(low, high)| (high - low).max_element());
    let figure = |units: f64| {
        let there = bench.image(
            &transformed(scene, DAffine3::from_scale(DVec3::splat(units / width))),
            "final",
            &[],
        )?;
        Ok(Figure::swept("difference", "width, units", units, difference(&here, &there), Some(0.001)))
    };
    [1e-4, 1e-2, 1e2, 1e4].into_iter().map(figure).collect()
}

/// Difference of the image, mirrored and turned round again: pixels share out directions in tiles, which a mirror turns
/// round with it, so that they find others.
pub fn mirrored(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let here = bench.image(scene, "final", &[])?;
    let there =
        bench.image(&transformed(scene, DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0))), "final", &[])?;
    let width = there.width as usize;
    let pixels = there.pixels.chunks_exact(width).flat_map(|row| row.iter().rev().copied()).collect();
    let there = Picture { pixels, ..there };
    Ok(vec![Figure::at_most("difference", difference(&here, &there), 0.05)])
}

/// Brightness of indirect light, turned about all axes, beside that upright.
pub fn turned(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let mean = |scene: &Scene| Ok::<f64, crate::Error>(grey(&bench.image(scene, "diffuse", &[])?));
    let upright = mean(scene)?;
    let figure = |degrees: f64| {
        let [x, y, z] = [1.0, 1.3, 0.7].map(|share| (share * degrees).to_radians());
        let turn = DAffine3::from_quat(DQuat::from_euler(EulerRot::XYZ, x, y, z));
        let value = mean(&transformed(scene, turn))? / upright - 1.0;
        Ok(Figure::swept("brightness beside upright", "turn, °", degrees, value, Some(0.02)))
    };
    [5.0, 15.0, 25.0, 35.0, 45.0].into_iter().map(figure).collect()
}

/// The whole scene, its lights and cameras, under a uniform scale, a mirror, a rotation or a translation.
fn transformed(scene: &Scene, transform: DAffine3) -> Scene {
    let mut scene = scene.clone();
    let scale = transform.matrix3.x_axis.length();
    let turn = |direction: glam::Vec3| (transform.matrix3 * direction.as_dvec3()).normalize().as_vec3();
    for instance in &mut scene.instances {
        instance.transform = transform * instance.transform;
    }
    for light in &mut scene.lights {
        match &mut light.kind {
            LightKind::Directional { direction, .. } => *direction = turn(*direction),
            LightKind::Point { position, radius } => {
                *position = transform.transform_point3(*position);
                *radius *= scale as f32;
                light.intensity *= (scale * scale) as f32;
            }
            LightKind::Spot { position, direction, radius, .. } => {
                *position = transform.transform_point3(*position);
                *direction = turn(*direction);
                *radius *= scale as f32;
                light.intensity *= (scale * scale) as f32;
            }
        }
    }
    for camera in &mut scene.cameras {
        camera.eye = transform.transform_point3(camera.eye);
        camera.forward = turn(camera.forward);
        camera.up = turn(camera.up);
    }
    scene
}
