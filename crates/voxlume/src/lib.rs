//! Voxel cone tracing on wgpu with pluggable voxel storage formats.
