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

/// What the image of a built-in pass is, where its entry doesn't say: after `run`, what it shows and is held against.
const BUILT_IN: [(&str, Shows, Reference); 6] = [
    ("effect/soft_shadow", Shows::Share, Reference::SoftShadow),
    ("effect/shadow", Shows::Share, Reference::SoftShadow),
    ("effect/ambient_occlusion", Shows::Share, Reference::AmbientOcclusion),
    ("effect/diffuse", Shows::Light, Reference::Diffuse),
    ("effect/specular", Shows::Light, Reference::Specular),
    ("composite", Shows::Light, Reference::Final),
];

/// What an entry's image shows and is held against: what is given, or what is so of the built-in pass that it runs.
pub(crate) fn described(
    run: &str,
    shows: Option<Located<Shows>>,
    reference: Option<Located<Reference>>,
) -> (Option<Located<Shows>>, Option<Located<Reference>>) {
    let known = BUILT_IN.iter().find(|(known, ..)| *known == run);
    let shown = || known.map(|(_, shows, _)| Located { value: *shows, span: None });
    let held_against = || known.map(|(.., reference)| Located { value: *reference, span: None });
    (shows.or_else(shown), reference.or_else(held_against))
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
