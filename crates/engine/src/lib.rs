//! The only user of wgpu: carries out a plan on a device.

mod bind;
mod counts;
mod error;
mod filler;
mod frame;
mod gpu;
mod host;
mod image;
mod layout;
mod program;
mod read;
mod record;
mod renderer;
mod resources;
mod scene;
mod schedule;
mod session;
mod timing;
mod upload;
mod volume;
mod work;

pub use error::Error;
pub use frame::{Frame, Passes};
pub use gpu::Gpu;
pub use host::Counters;
pub use image::Picture;
pub use read::OutOfRange;
pub use renderer::Renderer;
pub use session::Session;
pub use timing::{Clock, PassTime};
pub use volume::Texels;
