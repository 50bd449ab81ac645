//! A sheet closely over another.

use glam::{DAffine3, DVec3};
use voxlume::Scene;

use super::{Figure, Figures};
use crate::stability::bench::{Bench, mean};

/// Of the carpet over the floor, voxels.
const HEIGHTS: [f64; 6] = [0.03, 0.1, 0.25, 0.5, 0.75, 1.0];

/// Light of the colour that the carpet doesn't reflect, over that with the carpet alone, less 1: more where the white floor shines
/// through.
pub fn over_floor(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let voxel = f64::from(bench.grid(scene).voxel_size);
    let figure = |height: f64| {
        let mut scene = scene.clone();
        let lift = DAffine3::from_translation(DVec3::Y * (height * voxel));
        for carpet in scene.instances.iter_mut().filter(|instance| instance.name == "carpet") {
            carpet.transform = lift * carpet.transform;
        }
        let [_, over_floor, _] = mean(&bench.image(&scene, "diffuse", &[])?);
        // Without its floor the scene has the same bounds.
        scene.instances.retain(|instance| instance.name != "floor");
        let [_, alone, _] = mean(&bench.image(&scene, "diffuse", &[])?);
        Ok(Figure::swept(
            "green beside the carpet alone",
            "height, voxels",
            height,
            over_floor / alone - 1.0,
            Some(0.02),
        ))
    };
    HEIGHTS.into_iter().map(figure).collect()
}
