//! A pass as RON describes it.

use std::ops::Range;

use voxlume_fault::ron::{Fields, Node};
use voxlume_fault::{Fault, Faults, one_of, suggest};

use super::{Located, located, optional_word};
use crate::expansion::LAST;
use crate::limits::TEXTURE_2D;
use crate::plan::{ImageExtent, ImageTexel, Update};
use crate::shown::{Reference, Shows, choice, described};

/// A pass as RON describes it.
#[derive(Clone, Debug)]
pub struct PassEntry {
    /// Unique; the last part of `run` unless given.
    pub name: String,
    /// What it runs: a kind of pass, `effect/<name>`, or a path of a `.wgsl` file beside the pipeline.
    pub run: Located<String>,
    /// Resources that it reads.
    pub reads: Vec<Located<String>>,
    /// Resources that it makes.
    pub writes: Vec<Located<String>>,
    /// Resources that it reads and changes, after the one that makes them and before all that read them.
    pub updates: Vec<Located<String>>,
    /// What the scene must have for the pass to run.
    pub when: Option<Located<String>>,
    /// Layers of the image that it writes: one, or one for each four lights.
    pub layers: Option<Located<String>>,
    /// Name of its tracer, instead of the pipeline's.
    pub tracer: Option<Located<String>>,
    /// Other names under which its shader has what it reads: the graph's name and the shader's.
    pub aliases: Vec<(String, String)>,
    /// The image that an effect writes.
    pub image: ImageWords,
    /// When it runs.
    pub update: Update,
    /// What the image's size is divided by where the effect gathers, one of [`SCALES`]; what it gives is then brought up to
    /// the image's size.
    pub scale: Located<u32>,
    /// What a scene must have for `scale` to count as 1.
    pub full_size_when: Option<Located<String>>,
    /// Pixels along each side of a tile that share out the effect's directions: 4 or 8; 1 where each traces all.
    pub interleave: u32,
    /// What its image's values are; light unless given.
    pub shows: Option<Located<Shows>>,
    /// What its image is held against; the finest setting compared unless given.
    pub reference: Option<Located<Reference>>,
    /// Whether comparisons have its image; they do unless the entry says otherwise.
    pub compared: bool,
    /// Its parameters.
    pub params: Vec<Param>,
    /// Bytes of `run`'s value, for faults about the whole.
    pub span: Range<usize>,
}

/// What an entry says of the image that it writes.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageWords {
    /// `size: (width, height)`, or `size: "1/n"` of the screen's.
    pub extent: ImageExtent,
    /// `texel: "rgba16float"`.
    pub texel: ImageTexel,
    /// Where the file says any of it.
    pub span: Option<Range<usize>>,
}

/// Values of `scale`.
pub const SCALES: [u32; 4] = [1, 2, 4, 8];

/// They in words.
pub(crate) fn scales() -> String {
    one_of(SCALES.map(|scale| scale.to_string()).iter().map(String::as_str))
}

impl PassEntry {
    /// The value of a parameter, if the file gives it.
    pub fn param(&self, name: &str) -> Option<&Value> {
        self.params.iter().find(|param| param.name == name).map(|param| &param.value)
    }

    /// A parameter that is a word, with its place.
    pub(crate) fn word(&self, name: &str) -> Option<Located<String>> {
        let param = self.params.iter().find(|param| param.name == name)?;
        match &param.value {
            Value::Word(word) => Some(Located { value: word.clone(), span: param.span.clone() }),
            _ => None,
        }
    }

    /// The name under which the entry's shader has what the graph calls `name`.
    pub fn alias(&self, name: &str) -> String {
        let given = self.aliases.iter().find(|(known, _)| known == name);
        given.map_or_else(|| name.replace(LAST, "_last"), |(_, alias)| alias.clone())
    }

    /// Whether it runs a WGSL file that makes one image, not a kind of pass.
    pub fn is_effect(&self) -> bool {
        self.run.value.starts_with("effect/") || self.run.value.ends_with(".wgsl")
    }
}

/// A parameter of a pass.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub name_span: Option<Range<usize>>,
    /// Its value.
    pub value: Value,
    /// Where the value stands.
    pub span: Option<Range<usize>>,
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A finite number.
    Number(f64),
    /// A word such as `"spheres"`.
    Word(String),
    /// Numbers of a vector.
    Vector(Vec<f64>),
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Value::Number(number) => write!(f, "{number}"),
            Value::Word(word) => write!(f, "\"{word}\""),
            Value::Vector(list) => {
                let list: Vec<String> = list.iter().map(f64::to_string).collect();
                write!(f, "({})", list.join(", "))
            }
        }
    }
}

fn names(fields: &mut Fields<'_>, name: &str, faults: &mut Faults) -> Vec<Located<String>> {
    let items = fields.node(name).and_then(|node| faults.gather(node.items())).unwrap_or_default();
    items
        .iter()
        .filter_map(|item| Some(Located { value: faults.gather(item.get())?, span: Some(item.span()) }))
        .collect()
}

pub(super) fn pass_entry(node: Node<'_>, faults: &mut Faults) -> Option<PassEntry> {
    let mut fields = faults.gather(Fields::of(node))?;
    let run = located::<String>(&mut fields, "run", faults);
    let name = fields.optional::<String>("name", faults);
    let mut reads = names(&mut fields, "reads", faults);
    let aliases = take_aliases(&mut reads);
    let image = image_words(&mut fields, faults);
    let update = update(&mut fields, faults);
    let writes = names(&mut fields, "writes", faults);
    let updates = names(&mut fields, "updates", faults);
    let scale = scale(&mut fields, faults);
    let interleave = interleave(&mut fields, faults);
    let when = optional_word(&mut fields, "when", faults);
    let full_size_when = optional_word(&mut fields, "full_size_when", faults);
    let layers = optional_word(&mut fields, "layers", faults);
    let tracer = optional_word(&mut fields, "tracer", faults);
    let shows = choice(&mut fields, "shows", &Shows::WORDS, faults);
    let reference = choice(&mut fields, "reference", &Reference::WORDS, faults);
    let compared = fields.optional::<bool>("compare", faults).unwrap_or(true);
    let params: Vec<Param> = match fields.node("params").map(|node| faults.gather(node.fields())) {
        Some(Some(list)) => list
            .iter()
            .filter_map(|field| {
                Some(Param {
                    name: field.name.to_owned(),
                    name_span: Some(field.span.clone()),
                    value: faults.gather(value(field.value))?,
                    span: Some(field.value.span()),
                })
            })
            .collect(),
        _ => Vec::new(),
    };
    for (index, param) in params.iter().enumerate() {
        if params[..index].iter().any(|earlier: &Param| earlier.name == param.name)
            && let Some(span) = &param.name_span
        {
            let message = format!("parameter `{}` given twice", param.name);
            faults.push(Fault::new(message).at(node.source(), span.clone(), "the second"));
        }
    }
    fields.finish(faults);
    let run = run?;
    let (shows, reference) = described(&run.value, shows, reference);
    let span = run.span.clone().unwrap_or(node.head());
    let stem = run.value.rsplit('/').next().unwrap_or_default().trim_end_matches(".wgsl").to_owned();
    let name = name.unwrap_or(stem);
    Some(PassEntry {
        name,
        run,
        reads,
        writes,
        updates,
        when,
        layers,
        tracer,
        aliases,
        image,
        update,
        scale,
        full_size_when,
        interleave,
        shows,
        reference,
        compared,
        params,
        span,
    })
}

/// `NAME as ALIAS` among what is read: the name stays, and the aliases are given.
fn take_aliases(reads: &mut [Located<String>]) -> Vec<(String, String)> {
    let mut aliases = Vec::new();
    for read in reads {
        if let Some((name, alias)) = read.value.split_once(" as ") {
            let (name, alias) = (name.trim().to_owned(), alias.trim().to_owned());
            aliases.push((name.clone(), alias));
            read.value = name;
        }
    }
    aliases
}

/// Largest whole number that the screen's size can be divided by.
const LEAST_SHARE: u32 = 64;

/// `(width, height)` or `"1/n"`.
fn extent(node: Node<'_>) -> Option<ImageExtent> {
    if let Ok(share) = node.get::<String>() {
        let divisor = share.strip_prefix("1/")?.parse().ok()?;
        return (1..=LEAST_SHARE).contains(&divisor).then_some(ImageExtent::Screen { divisor });
    }
    let size = <[u32; 2]>::try_from(node.get::<Vec<u32>>().ok()?).ok()?;
    size.iter().all(|side| (1..=TEXTURE_2D).contains(side)).then_some(ImageExtent::Fixed(size))
}

/// `scale: 2`.
fn scale(fields: &mut Fields<'_>, faults: &mut Faults) -> Located<u32> {
    let Some(node) = fields.node("scale") else { return Located { value: 1, span: None } };
    let value = node.get::<u32>().ok().filter(|scale| SCALES.contains(scale));
    if value.is_none() {
        let label = format!("{}; 2 gathers for every second pixel along x and y", scales());
        let note = "an image that is itself smaller than the screen has `size: \"1/3\"`";
        faults.push(node.fault("unknown `scale`", label).note(note));
    }
    Located { value: value.unwrap_or(1), span: Some(node.span()) }
}

fn image_words(fields: &mut Fields<'_>, faults: &mut Faults) -> ImageWords {
    let (size, texel) = (fields.node("size"), fields.node("texel"));
    let span = size.or(texel).map(|node| node.span());
    let extent = size.and_then(|node| {
        let extent = extent(node);
        if extent.is_none() {
            let label = format!(
                "width and height, each from 1 to {TEXTURE_2D}; or a share of the screen's from \"1/1\" to \"1/{LEAST_SHARE}\""
            );
            faults.push(node.fault("`size` must be that of an image", label));
        }
        extent
    });
    let texel = texel.and_then(|node| {
        let word = faults.gather(node.get::<String>())?;
        let known = ImageTexel::WRITABLE.into_iter().find(|texel| texel.name() == word);
        if known.is_none() {
            let label = suggest(&word, ImageTexel::WRITABLE.map(ImageTexel::name));
            faults.push(node.fault(format!("unknown texel `{word}`"), label));
        }
        known
    });
    let extent = extent.unwrap_or(ImageExtent::SCREEN);
    ImageWords { extent, texel: texel.unwrap_or(ImageTexel::Rgba16Float), span }
}

/// `interleave: 4` or `8`; `true` is 4. 1 where each pixel stands for itself.
fn interleave(fields: &mut Fields<'_>, faults: &mut Faults) -> u32 {
    let Some(node) = fields.node("interleave") else { return 1 };
    match node.text() {
        "false" => 1,
        "true" | "4" => 4,
        "8" => 8,
        _ => {
            let label = "4 or 8 pixels along each side of a tile; `true` is 4, `false` none";
            faults.push(node.fault("unknown `interleave`", label));
            1
        }
    }
}

/// `update: (every: N)` or `update: on_demand`.
fn update(fields: &mut Fields<'_>, faults: &mut Faults) -> Update {
    let Some(node) = fields.node("update") else { return Update::Changed };
    if matches!(node.text(), "on_demand" | "\"on_demand\"") {
        return Update::OnDemand;
    }
    let every = Fields::of(node).ok().and_then(|mut fields| {
        let every = fields.node("every")?.get::<u32>().ok()?;
        fields.finish(faults);
        (1..=MOST_FRAMES).contains(&every).then_some(Update::Every(every))
    });
    every.unwrap_or_else(|| {
        let label = format!("`on_demand`, or `(every: N)` with N from 1 to {MOST_FRAMES} frames");
        faults.push(node.fault("unknown `update`", label));
        Update::Changed
    })
}

/// Most frames between two runs of a pass.
const MOST_FRAMES: u32 = 10_000;

fn value(node: Node<'_>) -> Result<Value, Faults> {
    let finite = |number: f64| {
        if number.is_finite() { Ok(number) } else { Err(node.fault("a parameter must be finite", "")) }
    };
    if node.text().starts_with(['"', 'r']) {
        return Ok(Value::Word(node.get()?));
    }
    if node.delimiter().is_some() {
        let numbers: Vec<f64> = node.get()?;
        return Ok(Value::Vector(numbers.into_iter().map(finite).collect::<Result<_, _>>()?));
    }
    if matches!(node.text(), "true" | "false") {
        return Ok(Value::Number(f64::from(u8::from(node.text() == "true"))));
    }
    Ok(Value::Number(finite(node.get()?)?))
}
