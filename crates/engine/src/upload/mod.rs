//! Scenes as buffers and textures.

pub(crate) mod frame;
#[cfg(test)]
mod layout;
pub(crate) mod light;
pub(crate) mod material;
pub(crate) mod mesh;
pub(crate) mod texture;
