//! CPU path tracer: the ground truth that the voxel effects are judged by.
//!
//! [`Tracer::new`] makes a scene ready, [`Tracer::render`] computes one of the [`Quantity`]s for a
//! camera, with each pixel's standard error; [`cache`] keeps pictures on disk. It shares no shading
//! code with the renderer: triangles, not voxels, and glTF's metallic-roughness model as its
//! specification writes it.
//!
//! What it models: GGX over Lambert with textures, normal maps and alpha masks, lights at their true
//! sizes, emissive triangles, a constant sky, and any number of bounces. What it doesn't: transmission,
//! refraction, volumes, texture minification (pixels are supersampled instead), multiple scattering
//! within the microsurface.

mod accel;
pub mod cache;
mod digest;
mod emitter;
mod error;
mod gather;
mod ggx;
mod light;
mod lobe;
mod panel;
mod picture;
mod render;
mod request;
mod rng;
mod sampling;
mod seen;
mod surface;
mod texture;
mod tracer;
mod triangle;
mod view;
mod visibility;

pub use error::Error;
pub use picture::Picture;
pub use request::{Gather, MAX_PIXELS, Panel, PixelSampling, Quantity, Reflection, Request};
pub use seen::Seen;
pub use tracer::Tracer;
