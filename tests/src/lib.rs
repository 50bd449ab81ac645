//! Helpers that the tests share: a device, scenes made in memory, the voxel substrate as read back from the
//! device, and what it should be, worked out in `f64`.

mod bits;
pub mod form_factor;
mod kernel;
mod mutate;
mod overlap;
mod random;
mod render;
mod scenes;
mod substrate;

pub use bits::{Bits, Ray};
pub use kernel::{Input, Kernel, noise_volume, run_kernel, run_kernel_of};
pub use mutate::{mutated_bytes, mutated_text};
pub use overlap::{Comparison, EPSILON, Separability, compare, overlaps_box};
pub use random::Random;
pub use render::{gi, gpu, image, mean, picture, plan_for, render, root};
pub use scenes::{add, built_in, place, sample, scene_from, scene_of, soup, span, triangle, triangles};
pub use substrate::{Run, Substrate, Surface};
