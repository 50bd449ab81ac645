//! glTF and RON scenes as plain, checked data.
//!
//! Everything here is in SI-like world units, right-handed, +y up as in glTF. Positions that can be
//! far from the origin are `f64`; [`Geometry`] is `f32` relative to an origin of the caller's choice.
//!
//! [`Scene::load`] reads a file; [`ron`] and [`gltf`] say what may be in it.

mod animation;
mod camera;
mod check;
mod data;
mod emissive;
mod geometry;
pub mod gltf;
mod limit;
mod load;
pub mod ron;
mod rule;
mod shape;
mod vertex;

pub use animation::{Animation, Key, Moved, Path};
pub use check::WORLD_LIMIT;
pub use data::*;
pub use limit::MEMORY_LIMIT;
