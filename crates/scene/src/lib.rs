//! glTF and RON scenes as plain, checked data.
//!
//! Everything here is in SI-like world units, right-handed, +y up as in glTF. Positions that can be
//! far from the origin are `f64`; [`Geometry`] is `f32` relative to an origin of the caller's choice.

mod data;
pub use data::*;
