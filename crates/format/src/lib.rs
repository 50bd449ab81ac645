//! Voxel storage formats: which volumes each needs and which WGSL modules it is made of.
