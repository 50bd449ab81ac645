//! The only user of wgpu: carries out a plan on a device.

mod bind;
mod encode;
mod error;
mod gpu;
mod image;
mod program;
mod read;
mod renderer;
mod resources;
mod timing;
mod upload;
mod volume;

pub use error::Error;
pub use gpu::Gpu;
pub use image::Picture;
pub use read::OutOfRange;
pub use renderer::{Passes, Renderer};
pub use timing::{Clock, PassTime};
pub use volume::Texels;
