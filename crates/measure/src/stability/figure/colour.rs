//! Light of one surface taken for that of another, and shadows of sheets.

use voxlume::Scene;

use super::{Figure, Figures};
use crate::stability::bench::{Bench, mean};

/// What any dielectric reflects of white.
const DIELECTRIC: f64 = 0.04;

/// Green over red light by a red wall that has a green one at its back.
pub fn crosstalk(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let [red, green, _] = mean(&bench.image(scene, "diffuse", &[])?);
    Ok(vec![Figure::at_most("green over red", green / red - DIELECTRIC, 0.1)])
}

/// Visibility of a light in the middle of a sheet's shadow.
pub fn shadow(bench: &Bench<'_>, scene: &Scene) -> Figures {
    let [visible, ..] = mean(&bench.image(scene, "shadow", &[])?);
    Ok(vec![Figure::at_most("light in the shadow", visible, 0.05)])
}
