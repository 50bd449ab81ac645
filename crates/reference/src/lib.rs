//! CPU path tracer: the ground truth that the voxel effects are judged by.
