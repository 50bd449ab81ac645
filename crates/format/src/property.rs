//! What formats are expected to hold.

/// A property that the conformance suite measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Property {
    /// The same radiance everywhere is the same on every level, from every direction. Over the radiance.
    Constant,
    /// A wall one voxel thick is opaque from its front on every level. Share of light that passes.
    Opaque,
    /// A wall between a red and a green room shows each its own colour (RAU figure 5.6). Over the radiance.
    Sides,
    /// What is seen over the sphere and all cells of a level, times a cell's face, stays what level 1 has. Relative.
    Energy,
    /// The radiance of a sum is the sum of the radiances. Over the brightest radiance.
    Linear,
    /// Turning and mirroring the voxels turns and mirrors what is seen. Over the brightest radiance.
    Symmetric,
    /// No NaN, no infinity, no negative radiance, opacity in [0, 1]. Number of samples.
    Finite,
    /// The same bits twice. Number of samples.
    Repeatable,
    /// The WGSL does what the CPU twin does. Over the bound.
    Twin,
}

impl Property {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Property::Constant => "constant",
            Property::Opaque => "opaque",
            Property::Sides => "sides",
            Property::Energy => "energy",
            Property::Linear => "linear",
            Property::Symmetric => "symmetric",
            Property::Finite => "finite",
            Property::Repeatable => "repeatable",
            Property::Twin => "twin",
        }
    }
}

/// A property that a format can't hold by nature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Miss {
    /// The property.
    pub property: Property,
    /// Where: what the suite's name of the place begins with, such as `level 0`; all places if empty.
    pub at: &'static str,
    /// By how much at most, in the property's measure.
    pub size: f64,
    /// Why.
    pub why: &'static str,
}
