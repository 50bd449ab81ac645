//! Texel encodings: how a format's numbers are stored.

/// Texels of four numbers that every WebGPU device can write and read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Texel {
    /// Four bytes, `[0, 1]` in 255 steps.
    Rgba8Unorm,
    /// Four bytes, `[−1, 1]` with 127 steps to either side of an exact zero.
    Rgba8Snorm,
    /// Four half-precision floats: 11 bits of precision, up to 65504.
    Rgba16Float,
    /// Four single-precision floats.
    Rgba32Float,
}

impl Texel {
    /// WebGPU's word for it.
    pub fn word(self) -> &'static str {
        match self {
            Texel::Rgba8Unorm => "rgba8unorm",
            Texel::Rgba8Snorm => "rgba8snorm",
            Texel::Rgba16Float => "rgba16float",
            Texel::Rgba32Float => "rgba32float",
        }
    }

    /// How many it takes.
    pub fn bytes(self) -> u64 {
        match self {
            Texel::Rgba8Unorm | Texel::Rgba8Snorm => 4,
            Texel::Rgba16Float => 8,
            Texel::Rgba32Float => 16,
        }
    }

    /// Path of the WGSL module that filters it. Where the device can't filter 32-bit floats, they are filtered by hand.
    pub fn filter(self, filters_float32: bool) -> &'static str {
        match self {
            Texel::Rgba32Float if !filters_float32 => "filter/by_hand",
            _ => "filter/hardware",
        }
    }
}

/// How a format's numbers are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encoding {
    /// The word in RON and on the command line.
    pub name: &'static str,
    /// Path of its WGSL module in the shader library.
    pub module: &'static str,
    /// What its `VolumeTarget` is.
    pub texel: Texel,
    /// What its `SignedVolumeTarget` is.
    pub signed_texel: Texel,
    /// Largest premultiplied radiance or coefficient; what is beyond is clamped and counted. WGSL knows it as
    /// `override ENCODING_RANGE`.
    pub range: f32,
    /// Whether a pipeline may declare another range: `rgba8:range=8`.
    pub declares_range: bool,
}

impl Encoding {
    /// Four bytes: radiance is a share of the range, opacity one of 1 (RAU §5.1.3).
    pub const RGBA8: Encoding = Encoding {
        name: "rgba8",
        module: "encoding/rgba8",
        texel: Texel::Rgba8Unorm,
        signed_texel: Texel::Rgba8Snorm,
        range: 4.0,
        declares_range: true,
    };

    /// Four half-precision floats.
    pub const RGBA16FLOAT: Encoding = Encoding {
        name: "rgba16float",
        module: "encoding/rgba16float",
        texel: Texel::Rgba16Float,
        signed_texel: Texel::Rgba16Float,
        range: 65504.0,
        declares_range: false,
    };

    /// Four single-precision floats, to less than they hold, so that sums of texels stay finite.
    pub const RGBA32FLOAT: Encoding = Encoding {
        name: "rgba32float",
        module: "encoding/rgba32float",
        texel: Texel::Rgba32Float,
        signed_texel: Texel::Rgba32Float,
        range: 1e30,
        declares_range: false,
    };
}

/// As in RON: `rgba16float`, `rgba8:range=4`.
impl std::fmt::Display for Encoding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)?;
        if self.declares_range { write!(f, ":range={}", self.range) } else { Ok(()) }
    }
}

/// The encodings to choose from.
#[derive(Clone, Debug)]
pub struct Encodings(Vec<Encoding>);

impl Encodings {
    /// The encodings of this crate.
    pub fn builtin() -> Encodings {
        Encodings(vec![Encoding::RGBA8, Encoding::RGBA16FLOAT, Encoding::RGBA32FLOAT])
    }

    /// Adds an encoding; one of the same name gives way.
    pub fn add(&mut self, encoding: Encoding) {
        self.0.retain(|other| other.name != encoding.name);
        self.0.push(encoding);
    }

    /// The encoding called `name`.
    pub fn get(&self, name: &str) -> Option<Encoding> {
        self.iter().find(|encoding| encoding.name == name)
    }

    /// All of them, in the order added.
    pub fn iter(&self) -> impl Iterator<Item = Encoding> {
        self.0.iter().copied()
    }
}
