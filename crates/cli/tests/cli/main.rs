//! The program, run as its users run it: exit codes, whole messages, and which files appear.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bad_output;
mod bad_pipeline;
mod bad_scene;
mod check;
mod compare;
mod explain;
mod faults;
mod folder;
mod frames;
mod render;
mod stability;
mod usage;
mod voxelize;
mod wgsl;
