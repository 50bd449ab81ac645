//! WGSL modules: linked, checked with naga, reflected.
