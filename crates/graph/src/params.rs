//! Parameters of a pass, laid out as its shader's `struct Params` says.

use naga::{Expression, Literal};
use voxlume_fault::{Fault, Faults, one_of, suggest};
use voxlume_scene::WORLD_LIMIT;
use voxlume_shader::{Field, Shader, StructLayout};

use crate::expansion::Context;
use crate::pass::{PassKind, Values};
use crate::pipeline::{Param, PassEntry, Pipeline, Value};
use crate::plan::{ParamBytes, Plan};

/// Reads the parameters of one pass, each at most once, and reports what nobody read.
#[derive(Debug)]
pub(crate) struct Params<'a> {
    pipeline: &'a Pipeline,
    entry: &'a PassEntry,
    asked: Vec<String>,
}

impl<'a> Params<'a> {
    pub fn of(pipeline: &'a Pipeline, entry: &'a PassEntry) -> Params<'a> {
        Params { pipeline, entry, asked: Vec::new() }
    }

    fn find(&mut self, name: &str) -> Option<&'a Param> {
        self.asked.push(name.to_owned());
        self.entry.params.iter().find(|param| param.name == name)
    }

    fn missing(&self, name: &str, label: String) -> Fault {
        let message = format!("pass `{}` lacks the parameter `{name}`", self.entry.name);
        self.pipeline.fault(&Some(self.entry.span.clone()), message, label)
    }

    fn wrong(&self, param: &Param, label: impl Into<String>) -> Fault {
        let message =
            format!("parameter `{}` of pass `{}` can't be {}", param.name, self.entry.name, param.value);
        self.pipeline.fault(&param.span, message, label)
    }

    /// A parameter of the kind itself, as a word.
    pub fn word(&mut self, kind: &dyn PassKind, name: &str, faults: &mut Faults) -> Option<&'static str> {
        let Values::Words(words) = spec(kind, name)? else { return None };
        let Some(param) = self.find(name) else {
            faults.push(self.missing(name, one_of(words.iter().copied())));
            return None;
        };
        if let Value::Word(word) = &param.value
            && let Some(known) = words.iter().find(|known| *known == word)
        {
            return Some(known);
        }
        faults.push(self.wrong(param, one_of(words.iter().copied())));
        None
    }

    /// A number of the kind itself, or the default where the file gives none.
    pub fn number_or(
        &mut self,
        kind: &dyn PassKind,
        name: &str,
        default: f64,
        faults: &mut Faults,
    ) -> Option<f64> {
        let Values::Number(low, high) = spec(kind, name)? else { return None };
        let Some(param) = self.find(name) else { return Some(default) };
        match param.value {
            Value::Number(n) if n >= *low && n <= *high => Some(n),
            _ => {
                faults.push(self.wrong(param, format!("a number from {low} to {high}")));
                None
            }
        }
    }

    /// Whether the file gives a parameter, which counts as read then.
    pub fn gives(&mut self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// A parameter of the kind itself, as a whole number.
    pub fn whole(&mut self, kind: &dyn PassKind, name: &str, faults: &mut Faults) -> Option<u32> {
        let Values::Whole(low, high) = spec(kind, name)? else { return None };
        let label = format!("a whole number from {low} to {high}");
        let Some(param) = self.find(name) else {
            faults.push(self.missing(name, label));
            return None;
        };
        match param.value {
            Value::Number(n) if n.fract() == 0.0 && n >= f64::from(*low) && n <= f64::from(*high) => {
                Some(n as u32)
            }
            _ => {
                faults.push(self.wrong(param, label));
                None
            }
        }
    }

    /// A parameter of the kind itself, as a point, if the file gives it.
    pub fn point(&mut self, kind: &dyn PassKind, name: &str, faults: &mut Faults) -> Option<[f64; 3]> {
        let Values::Point = spec(kind, name)? else { return None };
        let param = self.find(name)?;
        let numbers = match &param.value {
            Value::Vector(numbers) => <[f64; 3]>::try_from(numbers.as_slice()).ok(),
            _ => None,
        };
        let point = numbers.filter(|point| point.iter().all(|n| n.abs() <= WORLD_LIMIT));
        if point.is_none() {
            faults.push(self.wrong(param, format!("three numbers within ±{WORLD_LIMIT:e}")));
        }
        point
    }

    /// Refuses a value that was read, for what else is known.
    pub fn refuse(&self, name: &str, label: &str, faults: &mut Faults) {
        let given = self.entry.params.iter().find(|param| param.name == name);
        faults.extend(given.map(|param| self.wrong(param, label)));
    }

    /// The bytes of the shader's `Params`.
    pub fn uniform(&mut self, shader: &Shader, layout: &StructLayout, faults: &mut Faults) -> Vec<u8> {
        let mut bytes = vec![0; layout.size as usize];
        for field in &layout.fields {
            let at = field.offset as usize;
            if let Some(value) = self.field(shader, field, faults) {
                bytes[at..at + value.len()].copy_from_slice(&value);
            }
        }
        bytes
    }

    fn field(&mut self, shader: &Shader, field: &Field, faults: &mut Faults) -> Option<Vec<u8>> {
        // Angles are radians in shaders and degrees in files.
        let degrees = format!("{}_deg", field.name);
        let (param, scale) = match self.find(&degrees) {
            Some(param) => (param, std::f64::consts::PI / 180.0),
            None => match self.find(&field.name) {
                Some(param) => (param, 1.0),
                None => {
                    let default = default(field).and_then(|value| encode(shader, field, &value, 1.0));
                    if default.is_none() {
                        faults.push(self.missing(&field.name, describe(shader, field)));
                    }
                    return default;
                }
            },
        };
        let bytes = encode(shader, field, &param.value, scale);
        if bytes.is_none() {
            faults.push(self.wrong(param, describe(shader, field)));
        }
        bytes
    }

    /// Reports every parameter that nobody read. Of a pass that traces, another tracer may.
    pub fn finish(self, traces: bool, context: &mut Context<'_>) {
        let known: Vec<&str> =
            self.asked.iter().map(String::as_str).filter(|name| !name.ends_with("_deg")).collect();
        for param in &self.entry.params {
            let is_asked = self.asked.contains(&param.name);
            let is_traced = || context.trace_params().contains(&param.name);
            if !(is_asked || traces && is_traced()) {
                let message = format!("pass `{}` has no parameter `{}`", self.entry.name, param.name);
                let label = suggest(&param.name, known.iter().copied());
                context.faults.push(self.pipeline.fault(&param.name_span, message, label));
            }
        }
    }
}

/// Where a parameter of a pass is, and its bytes for a new value.
pub(crate) fn rewrite(plan: &Plan, pass: &str, name: &str, value: &Value) -> Result<ParamBytes, Fault> {
    let Some(of) = plan.passes.iter().find(|known| known.name == pass) else {
        let known = plan.passes.iter().map(|pass| pass.name.as_str());
        return Err(Fault::new(format!("no pass of the plan is called `{pass}`")).note(suggest(pass, known)));
    };
    // Angles are degrees where their name says so.
    let (field_name, scale) = match name.strip_suffix("_deg") {
        Some(radians) => (radians, std::f64::consts::PI / 180.0),
        None => (name, 1.0),
    };
    let Some(slot) = of.params.iter().find(|slot| slot.name == field_name) else {
        let known = of.params.iter().map(|slot| slot.name.as_str());
        let message =
            format!("pass `{pass}` has no parameter `{name}` that can change without planning again");
        return Err(Fault::new(message).note(suggest(name, known)));
    };
    let (shader, layout) = slot.shader;
    let shader = &plan.shaders[shader];
    let layout = shader.struct_layout(layout);
    let field = layout.as_ref().and_then(|layout| layout.fields.iter().find(|field| field.name == slot.name));
    let bytes = field.and_then(|field| Some((field, encode(shader, field, value, scale)?)));
    let Some((field, bytes)) = bytes else {
        let what = field.map(|field| describe(shader, field)).unwrap_or_default();
        return Err(Fault::new(format!("parameter `{name}` of pass `{pass}` can't be {value}")).note(what));
    };
    if slot.fixed {
        let message = format!("parameter `{name}` of pass `{pass}` can't change without planning again");
        return Err(Fault::new(message).note("the plan left something out for its value"));
    }
    Ok(ParamBytes { resource: slot.resource, offset: field.offset, bytes })
}

fn spec<'k>(kind: &'k dyn PassKind, name: &str) -> Option<&'k Values> {
    kind.words().iter().find(|word| word.name == name).map(|word| &word.values)
}

fn encode(shader: &Shader, field: &Field, value: &Value, scale: f64) -> Option<Vec<u8>> {
    let float = |n: f64| {
        let value = (n * scale) as f32;
        (value.is_finite() && range(field).is_none_or(|r| r.holds(n * scale)))
            .then(|| value.to_le_bytes().to_vec())
    };
    match (field.ty.as_str(), value) {
        ("f32", Value::Number(n)) => float(*n),
        ("u32", Value::Word(word)) => {
            let (_, n) = words(shader, &field.name).into_iter().find(|(name, _)| name == word)?;
            Some(n.to_le_bytes().to_vec())
        }
        ("u32", Value::Number(n))
            if words(shader, &field.name).is_empty() && n.fract() == 0.0 && *n >= 0.0 =>
        {
            range(field).is_none_or(|r| r.holds(*n)).then(|| (*n as u32).to_le_bytes().to_vec())
        }
        ("i32", Value::Number(n)) if n.fract() == 0.0 => Some((*n as i32).to_le_bytes().to_vec()),
        ("vec2f" | "vec3f" | "vec4f", Value::Vector(list)) => {
            let count = field.ty[3..4].parse::<usize>().ok()?;
            let floats: Option<Vec<_>> = list.iter().map(|n| float(*n)).collect();
            (list.len() == count).then_some(floats?.concat())
        }
        _ => None,
    }
}

/// Words that stand for a `u32`: the shader's constants called `<FIELD>_<WORD>`, the least first.
pub(crate) fn words(shader: &Shader, field: &str) -> Vec<(String, u32)> {
    let prefix = format!("{}_", field.to_uppercase());
    let constants = shader.module.constants.iter().filter_map(|(_, constant)| {
        let word = constant.name.as_ref()?.strip_prefix(&prefix)?.to_lowercase();
        match shader.module.global_expressions[constant.init] {
            Expression::Literal(Literal::U32(n)) => Some((word, n)),
            _ => None,
        }
    });
    let mut words: Vec<_> = constants.collect();
    words.sort_by_key(|(_, n)| *n);
    words
}

/// What a field takes, in words.
fn describe(shader: &Shader, field: &Field) -> String {
    let words = words(shader, &field.name);
    if !words.is_empty() {
        return one_of(words.iter().map(|(word, _)| word.as_str()));
    }
    let what = match field.ty.as_str() {
        "f32" => "a number".to_owned(),
        "u32" => "a whole number, not negative".to_owned(),
        "i32" => "a whole number".to_owned(),
        ty => format!("a list of {} numbers", &ty[3..4]),
    };
    let range = range(field).map(|range| range.text).unwrap_or_default();
    let within = if range.is_empty() { String::new() } else { format!(" in {range}") };
    // The comment says the range again.
    let doc = field.docs.replace(&format!(", {range}"), "");
    if doc.is_empty() { format!("{what}{within}") } else { format!("{what}{within}: {doc}") }
}

/// What a field's comment says that it is unless given: `1 unless given`, "`doubling` unless given".
fn default(field: &Field) -> Option<Value> {
    let before = &field.docs[..field.docs.find(" unless given")?];
    let word = before.rsplit(' ').next()?;
    match word.strip_prefix('`').and_then(|word| word.strip_suffix('`')) {
        Some(word) => Some(Value::Word(word.to_owned())),
        None => word.parse().ok().map(Value::Number),
    }
}

/// The range that a field's comment gives, such as `[0, 1)`.
struct Range {
    low: f64,
    low_open: bool,
    high: f64,
    high_open: bool,
    text: String,
}

impl Range {
    fn holds(&self, n: f64) -> bool {
        let above = if self.low_open { n > self.low } else { n >= self.low };
        let below = if self.high_open { n < self.high } else { n <= self.high };
        above && below
    }
}

fn range(field: &Field) -> Option<Range> {
    let doc = &field.docs;
    doc.match_indices(['[', '(']).find_map(|(start, open)| {
        let rest = &doc[start + 1..];
        let end = rest.find([']', ')'])?;
        let (low, high) = rest[..end].split_once(',')?;
        let number = |text: &str| match text.trim() {
            "∞" => Some(f64::INFINITY),
            text => text.parse().ok(),
        };
        Some(Range {
            low: number(low)?,
            low_open: open == "(",
            high: number(high)?,
            high_open: rest[end..].starts_with(')'),
            text: doc[start..start + end + 2].to_owned(),
        })
    })
}
