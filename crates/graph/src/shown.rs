//! What an entry says of the image that it makes: how it is shown, and what it is held against.

use voxlume_fault::ron::Fields;
use voxlume_fault::{Faults, suggest};

use crate::pipeline::Located;

/// What the values of an image are, which decides how a picture shows them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shows {
    /// A share in \[0, 1\] in the first channel, shown as it is. Other channels are shown, but not compared.
    Share,
    /// Radiance or irradiance: tone-mapped.
    #[default]
    Light,
    /// A direction n of length 1, shown as n/2 + 1/2.
    Normal,
    /// Reflectance in \[0, 1\]: sRGB-encoded, not tone-mapped.
    Albedo,
}

/// A quantity of the path tracer's that an image is held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// Visibility of the first light.
    SoftShadow,
    /// Accessibility, with the entry's parameters `distance` and `falloff`.
    AmbientOcclusion,
    /// Irradiance that surfaces and the sky send.
    Diffuse,
    /// Radiance along the glossy lobe.
    Specular,
    /// The whole image.
    Final,
}

impl Shows {
    /// The words for them.
    pub const WORDS: [(&'static str, Shows); 4] = [
        ("share", Shows::Share),
        ("light", Shows::Light),
        ("normal", Shows::Normal),
        ("albedo", Shows::Albedo),
    ];
}

impl Reference {
    /// The words for them.
    pub const WORDS: [(&'static str, Reference); 5] = [
        ("soft_shadow", Reference::SoftShadow),
        ("ambient_occlusion", Reference::AmbientOcclusion),
        ("diffuse", Reference::Diffuse),
        ("specular", Reference::Specular),
        ("final", Reference::Final),
    ];
}

/// Reads a field that is one of these words, if it is given.
pub(crate) fn choice<T: Copy>(
    fields: &mut Fields<'_>,
    name: &str,
    words: &[(&'static str, T)],
    faults: &mut Faults,
) -> Option<Located<T>> {
    let node = fields.node(name)?;
    let given: String = faults.gather(node.get())?;
    let found = words.iter().find(|(word, _)| *word == given);
    if found.is_none() {
        let label = suggest(&given, words.iter().map(|(word, _)| *word));
        faults.push(node.fault(format!("`{name}` can't be `{given}`"), label));
    }
    found.map(|(_, value)| Located { value: *value, span: Some(node.span()) })
}
