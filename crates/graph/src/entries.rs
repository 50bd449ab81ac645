//! A pipeline's passes, checked one by one.

use std::collections::BTreeSet;

use voxlume_fault::Faults;
use voxlume_fault::suggest;
use voxlume_shader::Library;

use crate::kind::{KINDS, Kind, SURFACE_IMAGES};
use crate::live::CONDITIONS;
use crate::pipeline::{PassEntry, Pipeline};
use crate::planner::unknown;

pub(crate) fn check_entries(pipeline: &Pipeline, library: &Library, faults: &mut Faults) {
    let mut names = BTreeSet::new();
    let kinds: Vec<&str> = KINDS
        .iter()
        .map(|kind| kind.name)
        .chain(library.paths().filter(|p| p.starts_with("effect/")))
        .collect();
    for pass in &pipeline.passes {
        if !names.insert(&pass.name) {
            let message = format!("two passes are called `{}`", pass.name);
            faults.push(pipeline.fault(&Some(pass.span.clone()), message, "the second; give it a `name`"));
        }
        let run = pass.run.value.as_str();
        let own = run.ends_with(".wgsl");
        if Kind::get(run).is_none() && !own && !(run.starts_with("effect/") && library.get(run).is_some()) {
            faults.push(unknown(pipeline, "pass", &pass.run, &kinds));
        }
        if let Some(when) = &pass.when
            && !CONDITIONS.contains(&when.value.as_str())
        {
            faults.push(unknown(pipeline, "condition", when, &CONDITIONS));
        }
        if let Some(layers) = pass.layers.as_ref().filter(|layers| layers.value != "lights") {
            let message = format!("unknown layers `{}`", layers.value);
            faults.push(pipeline.fault(&layers.span, message, "one of: lights (a layer for each four)"));
        }
        let described = [
            pass.shows.as_ref().map(|shows| ("shows", &shows.span)),
            pass.reference.as_ref().map(|reference| ("reference", &reference.span)),
        ];
        for (word, span) in described.into_iter().flatten().filter(|_| !is_screen(pass)) {
            let message = format!("pass `{}` makes no image that `{word}` could describe", pass.name);
            faults.push(pipeline.fault(
                span,
                message,
                "only a pass that makes an image for the screen has it",
            ));
        }
        match Kind::get(run) {
            Some(kind) => check_ports(pipeline, pass, kind, faults),
            None if pass.writes.len() != 1 => {
                let message = format!("pass `{}` must write one image", pass.name);
                let place = pass.writes.get(1).map_or(&pass.run.span, |second| &second.span);
                faults.push(pipeline.fault(place, message, "`writes: [\"name\"]`"));
            }
            None => {}
        }
    }
}

/// A kind's fixed ports: what it makes must be said, what it needs must be read.
pub(crate) fn check_ports(pipeline: &Pipeline, pass: &PassEntry, kind: &Kind, faults: &mut Faults) {
    let lists = [
        ("read", &pass.reads, kind.reads),
        ("write", &pass.writes, kind.writes),
        ("update", &pass.updates, kind.updates),
    ];
    for (word, given, ports) in lists {
        for port in ports.iter().filter(|port| !port.optional) {
            if !given.iter().any(|name| name.value == port.name) {
                let message = format!("pass `{}` must {word} `{}`", pass.name, port.name);
                faults.push(pipeline.fault(&Some(pass.span.clone()), message, port.sentence));
            }
        }
        for name in given {
            if !ports.iter().any(|port| port.name == name.value) {
                let message = format!("pass `{}` can't {word} `{}`", pass.name, name.value);
                let label = suggest(&name.value, ports.iter().map(|port| port.name));
                faults.push(pipeline.fault(&name.span, message, label));
            }
        }
    }
}

pub(crate) fn makes(pass: &PassEntry, image: &str) -> bool {
    let surface = pass.writes.iter().any(|name| name.value == "surface") && SURFACE_IMAGES.contains(&image);
    surface || (is_screen(pass) && pass.writes.iter().any(|name| name.value == image))
}

pub(crate) fn is_screen(pass: &PassEntry) -> bool {
    Kind::get(&pass.run.value).is_none_or(Kind::is_screen)
}

/// Every image that can be an output.
pub(crate) fn images(pipeline: &Pipeline) -> impl Iterator<Item = &str> {
    let screen = pipeline.passes.iter().filter(|pass| is_screen(pass)).flat_map(|pass| &pass.writes);
    let surface = pipeline.passes.iter().any(|pass| pass.writes.iter().any(|name| name.value == "surface"));
    screen.map(|name| name.value.as_str()).chain(SURFACE_IMAGES.into_iter().filter(move |_| surface))
}
