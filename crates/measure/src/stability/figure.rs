//! What is measured of cases, a kind of figure a file.

pub mod aperture;
pub mod bits;
pub mod brightness;
pub mod carpet;
pub mod colour;
pub mod energy;
pub mod feedback;
pub mod finite;
pub mod grazing;
pub mod irradiance;
pub mod leak;
pub mod lone;
pub mod moved;
pub mod opening;
pub mod range;
pub mod refused;

use voxlume::Scene;
use voxlume::twin::total_reflectance;

use crate::Error;

/// One figure.
pub struct Figure {
    /// What it is, with its place in a sweep if there is one.
    pub name: String,
    pub value: f64,
    /// What its size may be at most; `None`: it is only measured.
    pub bound: Option<f64>,
    /// What is swept, with its unit, and its value.
    pub at: Option<(&'static str, f64)>,
}

/// What a measurement gives.
pub type Figures = Result<Vec<Figure>, Error>;

impl Figure {
    /// A figure with a bound.
    pub fn at_most(name: impl Into<String>, value: f64, bound: f64) -> Figure {
        Figure { name: name.into(), value, bound: Some(bound), at: None }
    }

    /// A figure of a sweep. `axis` is what is swept, with its unit after a comma.
    pub fn swept(what: &str, axis: &'static str, at: f64, value: f64, bound: Option<f64>) -> Figure {
        let unit = axis.split_once(", ").map_or("", |(_, unit)| unit);
        let place = if (1e-3..1e4).contains(&at) { at.to_string() } else { format!("{at:e}") };
        Figure {
            name: format!("{what} at {place} {unit}").trim_end().to_owned(),
            value,
            bound,
            at: Some((axis, at)),
        }
    }

    /// Whether it is within its bound; a NaN never is.
    pub fn pass(&self) -> bool {
        self.bound.map_or(!self.value.is_nan(), |bound| self.value.abs() <= bound)
    }
}

/// What a scene's first material, the same in all channels, reflects of even light.
fn reflectance(scene: &Scene) -> f64 {
    let material = &scene.materials[0];
    let base = material.base_color.truncate().as_dvec3();
    total_reflectance(base, material.metallic.into(), material.roughness.into()).x
}
