//! The only user of wgpu: carries out a plan on a device.
