//! Values that are not finite, in any image or volume.

use voxlume::{Picture, Scene, Value};

use super::{Figure, Figures};
use crate::Error;
use crate::stability::bench::{Bench, images, volumes};

/// Everything that the pipeline has: every effect, and a bounce.
const ALL: [(&str, &str, Value); 2] =
    [("composite", "ao_weight", Value::Number(0.5)), ("bounce", "bounces", Value::Number(1.0))];

/// Counts them, with a pixel in the very middle.
pub fn finite(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let count = count(bench, scene, bench.settings.size.map(|side| side | 1))?;
    Ok(vec![Figure::at_most("values not finite", count as f64, 0.0)])
}

/// Counts them at sizes that no workgroup divides.
pub fn odd_sizes(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let sizes = [[1, 1], [3, 5], [33, 17], [65, 2]];
    let figure = |size: [u32; 2]| {
        let name = format!("values not finite of {}×{} pixels", size[0], size[1]);
        Ok(Figure::at_most(name, count(bench, scene, size)? as f64, 0.0))
    };
    sizes.into_iter().map(figure).collect()
}

/// In a picture.
pub fn not_finite(picture: &Picture) -> usize {
    picture.pixels.iter().flatten().filter(|value| !value.is_finite()).count()
}

fn count(bench: &Bench<'_>, scene: &Scene, size: [u32; 2]) -> Result<usize, Error> {
    let renderer = bench.render_at(bench.setting.resolution, size, scene, "final", &ALL)?;
    let mut count = 0;
    for name in images(&renderer) {
        count += not_finite(&renderer.picture(&name)?);
    }
    for (_, _, texels) in volumes(&renderer)? {
        count += texels.iter().flatten().filter(|value| !value.is_finite()).count();
    }
    Ok(count)
}
