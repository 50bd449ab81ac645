//! Texel encodings.

/// How a format's numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Four half-precision floats: 11 bits of precision, up to 65504.
    Rgba16Float,
}

impl Encoding {
    /// All of them.
    pub const ALL: [Encoding; 1] = [Encoding::Rgba16Float];

    /// The word in RON and WGSL.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Rgba16Float => "rgba16float",
        }
    }

    /// Bytes of a texel.
    pub fn texel_bytes(self) -> u64 {
        match self {
            Encoding::Rgba16Float => 8,
        }
    }
}
