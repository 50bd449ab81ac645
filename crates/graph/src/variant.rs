//! Storage formats and encodings by their words: `sh2:mip=projected:negatives=window`, `rgba8:range=8`.

use std::ops::Range;

use voxlume_fault::{Fault, Faults, one_of, suggest};
use voxlume_format::{Choices, Encoding, Encodings, Formats, StorageFormat};

use crate::pipeline::{Located, Pipeline};
use crate::registry::Registry;

/// A part of a word and where it stands.
struct Part<'w> {
    text: &'w str,
    span: Option<Range<usize>>,
}

/// `name:option=value:…`; an option without `=` has no value.
struct Variant<'w> {
    name: Part<'w>,
    options: Vec<(Part<'w>, Option<Part<'w>>)>,
}

impl<'w> Variant<'w> {
    fn of(word: &'w Located<String>) -> Variant<'w> {
        let text = word.value.as_str();
        // A plain string's text begins after its quote; one with escapes is marked as a whole.
        let plain = word.span.as_ref().filter(|span| span.len() == text.len() + 2);
        let part = |text_part: &'w str| {
            let at = text_part.as_ptr() as usize - text.as_ptr() as usize;
            let within = plain.map(|span| span.start + 1 + at..span.start + 1 + at + text_part.len());
            Part { text: text_part, span: within.or(word.span.clone()) }
        };
        let mut parts = text.split(':');
        // A name alone is marked with its quotes, as other words are.
        let name = parts.next().unwrap_or_default();
        let name = if name == text { Part { text, span: word.span.clone() } } else { part(name) };
        let options = parts.map(|option| match option.split_once('=') {
            Some((name, value)) => (part(name), Some(part(value))),
            None => (part(option), None),
        });
        Variant { name, options: options.collect() }
    }
}

/// The format that a word of the pipeline names, and what it chooses of its options.
pub(crate) fn format<'f>(
    pipeline: &Pipeline,
    word: &Located<String>,
    formats: &'f Formats,
    faults: &mut Faults,
) -> Option<(&'f dyn StorageFormat, Choices)> {
    let variant = Variant::of(word);
    let Some(format) = formats.get(variant.name.text) else {
        let names = formats.iter().map(StorageFormat::name);
        faults.push(unknown(pipeline, "storage format", &variant.name, names));
        return None;
    };
    let mut choices = Choices::default();
    for (name, word) in &variant.options {
        let Some(option) = format.options().iter().find(|option| option.name == name.text) else {
            let known = format.options().iter().map(|option| option.name);
            faults.push(unknown(pipeline, &format!("option of `{}`:", format.name()), name, known));
            continue;
        };
        match word {
            Some(word) if option.words.contains(&word.text) => choices.choose(option, word.text),
            word => {
                let message = format!("unknown `{}` of `{}`", option.name, format.name());
                let place = word.as_ref().unwrap_or(name);
                let label = one_of(option.words.iter().copied());
                faults.push(pipeline.fault(&place.span, message, label).note(option.summary));
            }
        }
    }
    Some((format, choices))
}

/// The encoding that a word of the pipeline names.
pub(crate) fn encoding(
    pipeline: &Pipeline,
    word: &Located<String>,
    encodings: &Encodings,
    faults: &mut Faults,
) -> Option<Encoding> {
    let variant = Variant::of(word);
    let Some(mut encoding) = encodings.get(variant.name.text) else {
        let names: Vec<&str> = encodings.iter().map(|encoding| encoding.name).collect();
        faults.push(unknown(pipeline, "encoding", &variant.name, names));
        return None;
    };
    for (name, value) in &variant.options {
        if !(encoding.declares_range && name.text == "range") {
            let what = format!("option of `{}`:", encoding.name);
            faults.push(unknown(pipeline, &what, name, encoding.declares_range.then_some("range")));
            continue;
        }
        let number = value.as_ref().and_then(|value| value.text.parse::<f32>().ok());
        match number.filter(|number| *number > 0.0 && *number <= 65504.0) {
            Some(number) => encoding.range = number,
            None => {
                let place = value.as_ref().unwrap_or(name);
                let label = "a number in (0, 65504]: the largest premultiplied radiance or coefficient";
                let message = format!("unknown `range` of `{}`", encoding.name);
                faults.push(pipeline.fault(&place.span, message, label));
            }
        }
    }
    Some(encoding)
}

fn unknown<'w>(
    pipeline: &Pipeline,
    what: &str,
    part: &Part<'_>,
    choices: impl IntoIterator<Item = &'w str>,
) -> Fault {
    let choices: Vec<&str> = choices.into_iter().collect();
    let label = if choices.is_empty() { "it has none".into() } else { suggest(part.text, choices) };
    pipeline.fault(&part.span, format!("unknown {what} `{}`", part.text), label)
}

/// Whether a storage format's word with its options, and an encoding's with its own, are known.
///
/// # Errors
/// Each unknown name and option.
pub fn check_variant(
    pipeline: &Pipeline,
    registry: &Registry,
    format_word: &str,
    encoding_word: &str,
) -> Result<(), Faults> {
    let mut pipeline = pipeline.clone();
    pipeline.format = Located { value: format_word.to_owned(), span: None };
    pipeline.encoding = Located { value: encoding_word.to_owned(), span: None };
    let mut faults = Faults::default();
    format(&pipeline, &pipeline.format, &registry.formats, &mut faults);
    encoding(&pipeline, &pipeline.encoding, &registry.encodings, &mut faults);
    faults.into_result(())
}
