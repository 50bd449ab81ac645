//! Texel encodings.

/// How a format's numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Encoding {
    /// Four bytes: radiance is a share of `range`, opacity one of 1 (RAU §5.1.3). A signed volume has 127 steps to
    /// either side of an exact zero, the others 255.
    Rgba8 {
        /// Largest premultiplied radiance or coefficient; what is beyond is clamped and counted.
        range: f32,
    },
    /// Four half-precision floats: 11 bits of precision, up to 65504.
    Rgba16Float,
    /// Four single-precision floats.
    Rgba32Float,
}

impl Encoding {
    /// The range of `rgba8` where none is declared.
    pub const DEFAULT_RANGE: f32 = 4.0;

    /// All of them.
    pub const ALL: [Encoding; 3] =
        [Encoding::Rgba8 { range: Self::DEFAULT_RANGE }, Encoding::Rgba16Float, Encoding::Rgba32Float];

    /// The word in RON and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Rgba8 { .. } => "rgba8",
            Encoding::Rgba16Float => "rgba16float",
            Encoding::Rgba32Float => "rgba32float",
        }
    }

    /// Path of its WGSL module in the shader library.
    pub fn module(self) -> &'static str {
        match self {
            Encoding::Rgba8 { .. } => "encoding/rgba8",
            Encoding::Rgba16Float => "encoding/rgba16float",
            Encoding::Rgba32Float => "encoding/rgba32float",
        }
    }

    /// Path of the WGSL module that filters it. Where the device can't filter 32-bit floats, they are filtered by hand.
    pub fn filter(self, filters_float32: bool) -> &'static str {
        match self {
            Encoding::Rgba32Float if !filters_float32 => "filter/by_hand",
            _ => "filter/hardware",
        }
    }

    /// Largest number that it holds.
    pub fn range(self) -> f32 {
        match self {
            Encoding::Rgba8 { range } => range,
            Encoding::Rgba16Float => 65504.0,
            // Sums of texels stay finite.
            Encoding::Rgba32Float => 1e30,
        }
    }

    /// Bytes of a texel.
    pub fn texel_bytes(self) -> u64 {
        match self {
            Encoding::Rgba8 { .. } => 4,
            Encoding::Rgba16Float => 8,
            Encoding::Rgba32Float => 16,
        }
    }
}

/// As in RON: `rgba16float`, `rgba8:range=4`.
impl std::fmt::Display for Encoding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Encoding::Rgba8 { range } => write!(f, "rgba8:range={range}"),
            _ => f.write_str(self.name()),
        }
    }
}
