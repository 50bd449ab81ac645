//! A pipeline's passes, checked one by one.

use std::collections::{BTreeMap, BTreeSet};

use voxlume_fault::Faults;
use voxlume_fault::suggest;
use voxlume_shader::Library;

use crate::expansion::LAST;
use crate::expansion::context::read_of;
use crate::live::CONDITIONS;
use crate::pass::{Kinds, PassKind, Port, Sort};
use crate::pipeline::{Located, PassEntry, Pipeline};
use crate::plan::{ImageExtent, ImageTexel};
use crate::planner::unknown;

pub(crate) fn check_entries(pipeline: &Pipeline, kinds: &Kinds, library: &Library, faults: &mut Faults) {
    let mut names = BTreeSet::new();
    let effects = library.paths().filter(|path| path.starts_with("effect/"));
    let known: Vec<&str> = kinds.iter().map(PassKind::name).chain(effects).collect();
    let sorts = sorts(pipeline, kinds);
    for pass in &pipeline.passes {
        if !names.insert(&pass.name) {
            let message = format!("two passes are called `{}`", pass.name);
            faults.push(pipeline.fault(&Some(pass.span.clone()), message, "the second; give it a `name`"));
        }
        let run = pass.run.value.as_str();
        let own = run.ends_with(".wgsl");
        if kinds.get(run).is_none() && !own && !(run.starts_with("effect/") && library.get(run).is_some()) {
            faults.push(unknown(pipeline, "pass", &pass.run, &known));
        }
        let conditions = CONDITIONS.map(|(word, ..)| word);
        let words = [&pass.when, &pass.full_size_when].into_iter().flatten();
        for when in words.filter(|when| !conditions.contains(&when.value.as_str())) {
            faults.push(unknown(pipeline, "condition", when, &conditions));
        }
        if let Some(layers) = pass.layers.as_ref().filter(|layers| layers.value != "lights") {
            let message = format!("unknown layers `{}`", layers.value);
            faults.push(pipeline.fault(&layers.span, message, "one of: lights (a layer for each four)"));
        }
        check_means(pipeline, pass, faults);
        for read in pass.reads.iter().filter(|read| read.value.ends_with(LAST)) {
            let name = read.value.trim_end_matches(LAST);
            let sort = sorts.get(name).filter(|sort| **sort != Sort::IMAGE && sort.images.is_empty());
            if let Some(sort) = sort {
                let label = format!("only images have one; this is of the sort `{}`", sort.name);
                faults.push(pipeline.fault(&read.span, format!("`{name}` has no last value"), label));
            }
        }
        let described = [
            pass.shows.as_ref().map(|shows| ("shows", &shows.span)),
            pass.reference.as_ref().map(|reference| ("reference", &reference.span)),
        ];
        for (word, span) in described.into_iter().flatten().filter(|_| !is_image(kinds, pass)) {
            let message = format!("pass `{}` makes no image that `{word}` could describe", pass.name);
            faults.push(pipeline.fault(
                span,
                message,
                "only a pass that makes an image for the screen has it",
            ));
        }
        match kinds.get(run) {
            Some(kind) => check_ports(pipeline, pass, kind, &sorts, faults),
            None if pass.writes.len() != 1 => {
                let message = format!("pass `{}` must write one image", pass.name);
                let place = pass.writes.get(1).map_or(&pass.run.span, |second| &second.span);
                faults.push(pipeline.fault(place, message, "`writes: [\"name\"]`"));
            }
            None => {}
        }
    }
}

/// `interleave` and `scale` take means over pixels: only of an effect's image, and not of every one.
fn check_means(pipeline: &Pipeline, pass: &PassEntry, faults: &mut Faults) {
    let scaled = pass.scale.value > 1;
    let texel = pass.image.texel;
    let words = [(pass.interleave > 1, "interleave"), (scaled, "scale")];
    for (_, word) in words.into_iter().filter(|(given, _)| *given) {
        if !pass.is_effect() {
            let message = format!("pass `{}` has no `{word}`", pass.name);
            faults.push(pipeline.fault(&pass.run.span, message, "only an effect has it"));
        } else if texel != ImageTexel::Rgba16Float {
            let message = format!("pass `{}` can't have `{word}` with {} texels", pass.name, texel.name());
            faults.push(pipeline.fault(&pass.image.span, message, "it takes means, of rgba16float alone"));
        }
    }
    if scaled && pass.image.extent != ImageExtent::SCREEN {
        let message = format!("pass `{}` has both `scale` and `size`", pass.name);
        let label =
            "`scale` brings an effect up to the screen's size; an image of another size is left as it is";
        faults.push(pipeline.fault(&pass.scale.span, message, label));
    }
}

/// What sort of thing each name is, by the pass that writes it.
pub(crate) fn sorts(pipeline: &Pipeline, kinds: &Kinds) -> BTreeMap<String, Sort> {
    let mut sorts = BTreeMap::new();
    for entry in &pipeline.passes {
        for (name, port) in entry.writes.iter().zip(kinds.of(entry).writes()) {
            sorts.insert(name.value.clone(), port.sort);
        }
    }
    sorts
}

/// A kind's ports: what it makes must be said, what it needs must be read.
fn check_ports(
    pipeline: &Pipeline,
    pass: &PassEntry,
    kind: &dyn PassKind,
    sorts: &BTreeMap<String, Sort>,
    faults: &mut Faults,
) {
    let mut missing = |word: &str, port: &Port| {
        let message = format!("pass `{}` must {word} `{}`", pass.name, port.name);
        faults.push(pipeline.fault(&Some(pass.span.clone()), message, port.sentence));
    };
    for port in kind.reads().iter().filter(|port| !port.optional) {
        if read_of(sorts, pass, kind, port.name).is_none() {
            missing("read", port);
        }
    }
    let of_sort = |name: &Located<String>, port: &Port| sorts.get(&name.value) == Some(&port.sort);
    for port in kind.updates() {
        if !pass.updates.iter().any(|name| name.value == port.name || of_sort(name, port)) {
            missing("update", port);
        }
    }
    for port in kind.writes().iter().skip(pass.writes.len()) {
        missing("write", port);
    }
    let mut surplus = |word: &str, name: &Located<String>, ports: &[Port]| {
        let message = format!("pass `{}` can't {word} `{}`", pass.name, name.value);
        let mut label = suggest(&name.value, ports.iter().map(|port| port.name));
        let open = |port: &&Port| port.sort == Sort::IMAGE && read_of(sorts, pass, kind, port.name).is_none();
        let open = ports.iter().find(|port| open(port) && !port.optional).or(ports.iter().find(open));
        if let (true, Some(port)) = (sorts.get(&name.value) == Some(&Sort::IMAGE), open) {
            label = format!("say as which image: `{} as {}`; {label}", name.value, port.name);
        }
        faults.push(pipeline.fault(&name.span, message, label));
    };
    let reads = kind.reads();
    for name in &pass.reads {
        let is = |port: &Port| read_of(sorts, pass, kind, port.name) == Some(name.value.as_str());
        let fits =
            |port: &Port| sorts.get(name.value.trim_end_matches(LAST)).is_none_or(|sort| *sort == port.sort);
        if !reads.iter().any(|port| is(port) && fits(port)) {
            surplus("read", name, reads);
        }
    }
    for name in &pass.updates {
        let updates = kind.updates();
        if !updates.iter().any(|port| name.value == port.name || of_sort(name, port)) {
            surplus("update", name, updates);
        }
    }
    for name in pass.writes.iter().skip(kind.writes().len()) {
        surplus("write", name, kind.writes());
    }
}

/// Whether an entry makes an image that can be the output.
pub(crate) fn is_image(kinds: &Kinds, entry: &PassEntry) -> bool {
    kinds.of(entry).writes().iter().any(|port| port.sort == Sort::IMAGE)
}

/// The images that an entry makes and that can be the output.
fn images_of<'e>(kinds: &'e Kinds, entry: &'e PassEntry) -> impl Iterator<Item = &'e str> {
    entry.writes.iter().zip(kinds.of(entry).writes()).flat_map(|(name, port)| {
        let own = (port.sort == Sort::IMAGE).then_some(name.value.as_str());
        own.into_iter().chain(port.sort.images.iter().copied())
    })
}

pub(crate) fn makes(kinds: &Kinds, entry: &PassEntry, image: &str) -> bool {
    images_of(kinds, entry).any(|made| made == image)
}

/// Every image that can be the output: first those that have a name of their own.
pub(crate) fn images<'p>(pipeline: &'p Pipeline, kinds: &'p Kinds) -> Vec<&'p str> {
    let (own, parts): (Vec<&PassEntry>, Vec<&PassEntry>) =
        pipeline.passes.iter().partition(|entry| is_image(kinds, entry));
    own.into_iter().chain(parts).flat_map(|entry| images_of(kinds, entry)).collect()
}
