//! Brightness over resolutions.

use voxlume::Scene;

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
