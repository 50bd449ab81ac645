//! Buffers and textures of a plan.

use voxlume_format::{Encoding, Numbers};
use voxlume_shader::{BindingKind, SampleKind};

/// A buffer or texture.
#[derive(Clone, Debug, PartialEq)]
pub struct Resource {
    /// Unique name; for images, the name in the pipeline.
    pub name: String,
    /// What it is.
    pub kind: ResourceKind,
    /// How long its value is kept.
    pub life: Life,
}

/// How long a resource's value is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Life {
    /// Until a pass writes it again.
    Frame,
    /// A pass also reads the value before the last writing: there are two of it, which change places when a pass
    /// writes.
    History,
    /// Whoever writes it leaves it right for whoever comes next, in this frame or a later one: no pass depends on another
    /// one through it.
    Kept,
}

/// What a resource is.
#[derive(Clone, Debug, PartialEq)]
pub enum ResourceKind {
    /// Part of the scene or the frame, supplied by the engine under this name.
    Scene,
    /// A uniform buffer that begins with these bytes: a grid's values, or a pass's parameters.
    Uniform(Vec<u8>),
    /// A storage buffer of a fixed number of bytes.
    Buffer(u64),
    /// A storage buffer with so many bytes for each occupied voxel.
    PerVoxel(u64),
    /// A storage buffer with so many bytes for each occupied cell of all levels.
    PerCell(u64),
    /// A 3D texture.
    Volume {
        /// Texels of mip level 0.
        size: [u32; 3],
        /// Mip levels.
        mips: u32,
        /// Texel encoding.
        encoding: Encoding,
        /// What its texels hold.
        numbers: Numbers,
    },
    /// A 2D texture.
    Image {
        /// Texels along x and y.
        extent: ImageExtent,
        /// Its texels.
        texel: ImageTexel,
        /// Array layers.
        layers: u32,
        /// Mip levels.
        mips: u32,
    },
    /// A target that nothing is drawn on, which gives rasterization its extent: a square of one byte a texel.
    Raster {
        /// Side in texels.
        side: u32,
    },
}

/// The size of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageExtent {
    /// The screen's size over a whole number, rounded up.
    Screen {
        /// 1 for the screen's own size.
        divisor: u32,
    },
    /// So many texels along x and y, whatever the screen.
    Fixed([u32; 2]),
}

impl ImageExtent {
    /// The screen's own size.
    pub const SCREEN: ImageExtent = ImageExtent::Screen { divisor: 1 };

    /// Texels along x and y on a screen of this size.
    pub fn size(self, screen: [u32; 2]) -> [u32; 2] {
        match self {
            ImageExtent::Screen { divisor } => screen.map(|side| side.div_ceil(divisor.max(1))),
            ImageExtent::Fixed(size) => size,
        }
    }
}

/// Texels of images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageTexel {
    /// Four half floats.
    Rgba16Float,
    /// Four floats.
    Rgba32Float,
    /// Two floats.
    Rg32Float,
    /// One float.
    R32Float,
    /// One whole number.
    R32Uint,
    /// Four shares of 1, 8 bits each.
    Rgba8Unorm,
    /// sRGB colour, linear alpha, 8 bits each; only drawn, never written by a compute shader.
    Rgba8Srgb,
    /// 32-bit float depth; only drawn.
    Depth32,
}

impl ImageTexel {
    /// Those that an effect can write: WebGPU guarantees each as a storage texture.
    pub const WRITABLE: [ImageTexel; 6] = [
        ImageTexel::Rgba16Float,
        ImageTexel::Rgba32Float,
        ImageTexel::Rg32Float,
        ImageTexel::R32Float,
        ImageTexel::R32Uint,
        ImageTexel::Rgba8Unorm,
    ];

    /// The word in RON, which is WGSL's for a storage texture of such texels.
    pub fn name(self) -> &'static str {
        match self {
            ImageTexel::Rgba16Float => "rgba16float",
            ImageTexel::Rgba32Float => "rgba32float",
            ImageTexel::Rg32Float => "rg32float",
            ImageTexel::R32Float => "r32float",
            ImageTexel::R32Uint => "r32uint",
            ImageTexel::Rgba8Unorm => "rgba8unorm",
            ImageTexel::Rgba8Srgb => "rgba8srgb",
            ImageTexel::Depth32 => "depth32float",
        }
    }

    /// What a shader's variable wants instead, where it can't be bound to an image of such texels.
    pub(crate) fn misfit(self, variable: &BindingKind) -> Option<String> {
        match variable {
            BindingKind::StorageTexture { format, .. } => {
                (format != self.name()).then(|| format!("a storage texture of {format}"))
            }
            BindingKind::Texture { sample, filterable, .. } => {
                let own = match self {
                    ImageTexel::Depth32 => SampleKind::Depth,
                    ImageTexel::R32Uint => SampleKind::Uint,
                    _ => SampleKind::Float,
                };
                let filters =
                    matches!(self, ImageTexel::Rgba16Float | ImageTexel::Rgba8Unorm | ImageTexel::Rgba8Srgb);
                let what = match sample {
                    SampleKind::Float => "floats",
                    SampleKind::Depth => "depths",
                    SampleKind::Uint => "whole numbers, not negative",
                    SampleKind::Sint => "whole numbers",
                };
                if own != *sample {
                    return Some(format!("a texture of {what}"));
                }
                (own == SampleKind::Float && *filterable && !filters)
                    .then(|| "texels that a sampler filters; `textureLoad` reads these".to_owned())
            }
            _ => Some("no texture".to_owned()),
        }
    }

    /// Bytes of a texel.
    pub fn bytes(self) -> u64 {
        match self {
            ImageTexel::Rgba32Float => 16,
            ImageTexel::Rgba16Float | ImageTexel::Rg32Float => 8,
            ImageTexel::R32Float
            | ImageTexel::R32Uint
            | ImageTexel::Rgba8Unorm
            | ImageTexel::Rgba8Srgb
            | ImageTexel::Depth32 => 4,
        }
    }
}
