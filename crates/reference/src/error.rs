//! What can go wrong.

use crate::request::MAX_PIXELS;

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The caller raised the cancel flag.
    #[error("cancelled")]
    Cancelled,
    /// A side is zero, or there are more than [`MAX_PIXELS`] pixels.
    #[error(
        "picture of {width}x{height} pixels: each side must be at least 1, with at most {MAX_PIXELS} pixels in all"
    )]
    Size {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// Fewer than two samples a pixel.
    #[error("{0} samples a pixel: at least 2 are needed to tell the standard error")]
    Samples(u32),
    /// A camera that sees nothing sensible.
    #[error("camera `{name}`: {fault}")]
    Camera {
        /// [`voxlume_scene::Camera::name`].
        name: String,
        /// Which field, and what it must be.
        fault: &'static str,
    },
    /// A distance or falloff outside its range.
    #[error(
        "ambient occlusion to distance {distance} with falloff {falloff}: the distance must be above 0 \
         (infinity is allowed) and the falloff finite and at least 0"
    )]
    AmbientOcclusion {
        /// As in the request.
        distance: f32,
        /// As in the request.
        falloff: f32,
    },
    /// A light that the scene doesn't have.
    #[error("no light {index}: {}", describe_lights(.lights))]
    Light {
        /// As in the request.
        index: usize,
        /// The names of the scene's lights, in order.
        lights: Vec<String>,
    },
    /// More triangles than indices reach.
    #[error("{0} triangles: the reference takes at most {max}", max = crate::tracer::MAX_TRIANGLES)]
    Triangles(usize),
    /// A light or surface so bright that radiance leaves the range of `f32`.
    #[error(
        "pixel ({x}, {y}) is not finite: a light, an emission or the sky is too bright for 32-bit floats"
    )]
    NotFinite {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
    },
}

fn describe_lights(lights: &[String]) -> String {
    if lights.is_empty() {
        return "the scene has no lights".into();
    }
    let listed: Vec<String> = lights.iter().enumerate().map(|(i, name)| format!("{i} `{name}`")).collect();
    format!("the scene has {}", listed.join(", "))
}
