//! Measures pipelines: [`compare::Sweep`] holds effects against the path tracer, [`stability::Suite`] runs hard cases.
//!
//! Both take a [`Progress`] that is told what is being done, and a flag that stops them; neither prints.

pub mod compare;
mod device;
pub mod effect;
mod error;
mod frames;
pub mod outfile;
pub mod picture;
mod progress;
mod settings;
mod shown;
pub mod stability;
mod statistics;
mod tone;
mod words;

pub use device::describe;
pub use error::Error;
pub use frames::Frames;
pub use progress::Progress;
pub use settings::Settings;
pub use shown::{channel_shows, shows};
