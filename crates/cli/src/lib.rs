//! The program voxlume.
