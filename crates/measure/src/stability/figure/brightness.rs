//! Brightness over resolutions, and over places of the grid.

use glam::{DAffine3, DVec3};
use voxlume::Scene;
use voxlume::scene::Instance;

use super::{Figure, Figures};
use crate::stability::bench::{Bench, grey};

/// What everything is held against.
const BASE: u32 = 64;

/// Mean of the image over that at 64³, less 1.
pub fn brightness(bench: &Bench<'_>, scene: &Scene) -> Figures {
    if bench.setting.resolution == BASE {
        return Ok(Vec::new());
    }
    let mean = |resolution| {
        Ok::<f64, crate::Error>(grey(
            &bench.render_at(resolution, bench.settings.size, scene, "final", &[])?.picture("final")?,
        ))
    };
    let value = mean(bench.setting.resolution)? / mean(BASE)? - 1.0;
    let bound = (bench.setting.resolution > BASE).then_some(0.03);
    let at = f64::from(bench.setting.resolution);
    Ok(vec![Figure::swept("brightness beside 64³", "grid, voxels", at, value, bound)])
}

/// Mean of the image over that where the outermost walls run through the middles of voxels, less 1: something small outside shifts
/// the grid.
pub fn over_offsets(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let voxel = f64::from(bench.grid(scene).voxel_size);
    let low = scene.bounds().map_or(DVec3::ZERO, |(low, _)| low);
    let mean = |scene: &Scene| Ok::<f64, crate::Error>(grey(&bench.image(scene, "final", &[])?));
    let base = mean(scene)?;
    let figure = |offset: f64| {
        let mut scene = scene.clone();
        let size = 1e-3 * voxel;
        let corner = low - DVec3::splat(offset * voxel);
        // The first mesh is the walls' box.
        let transform =
            DAffine3::from_scale_rotation_translation(DVec3::splat(size), glam::DQuat::IDENTITY, corner);
        scene.instances.push(Instance { name: "speck".into(), mesh: 0, transform, moving: false });
        let value = mean(&scene)? / base - 1.0;
        Ok(Figure::swept("brightness beside no offset", "offset, voxels", offset, value, Some(0.02)))
    };
    (1..8).map(|eighth| figure(f64::from(eighth) / 8.0)).collect()
}
