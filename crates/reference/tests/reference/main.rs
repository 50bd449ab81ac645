//! The path tracer against closed forms, quadratures and its own promises.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod brdf;
mod cache;
mod determinism;
mod furnace;
mod lights;
mod materials;
mod messages;
mod occlusion;
mod panels;
mod precision;
mod stage;
