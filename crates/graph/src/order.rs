//! The order of passes, from what they read, write and update.

use std::collections::HashMap;

use voxlume_fault::{Fault, Faults, suggest};

use crate::expansion::LAST;
use crate::pass::{Kinds, PassKind};
use crate::pipeline::{Located, PassEntry, Pipeline};

/// Makers of each resource: the pass that writes it, then those that update it, in the file's order.
pub(crate) struct Makers<'a>(HashMap<&'a str, Vec<usize>>);

impl<'a> Makers<'a> {
    /// Finds them; a fault for a second writer and for whatever nobody writes.
    pub fn of(pipeline: &'a Pipeline, kinds: &Kinds, faults: &mut Faults) -> Makers<'a> {
        let mut makers: HashMap<&str, Vec<usize>> = HashMap::new();
        for (index, pass) in pipeline.passes.iter().enumerate() {
            for name in &pass.writes {
                let of = makers.entry(&name.value).or_default();
                if let Some(first) = of.first() {
                    let first = &pipeline.passes[*first].name;
                    let message =
                        format!("`{}` is written twice, by `{first}` and `{}`", name.value, pass.name);
                    faults.push(pipeline.fault(
                        &name.span,
                        message,
                        "a second writer: `updates` changes what is there",
                    ));
                } else {
                    of.push(index);
                }
            }
        }
        let written: Vec<&str> = {
            let mut names: Vec<&str> = makers.keys().copied().collect();
            names.sort_unstable();
            names
        };
        for pass in &pipeline.passes {
            for name in pass.reads.iter().chain(&pass.updates) {
                // What a kind can't read at all is a fault of its own.
                let knows = |kind: &dyn PassKind| {
                    kind.reads().iter().chain(kind.updates()).any(|port| port.name == pass.alias(&name.value))
                };
                let expected = kinds.get(&pass.run.value).is_none_or(knows);
                if expected && !makers.contains_key(name.value.trim_end_matches(LAST)) {
                    let label = suggest(&name.value, written.iter().copied());
                    faults.push(pipeline.fault(
                        &name.span,
                        format!("no pass writes `{}`", name.value),
                        label,
                    ));
                }
            }
        }
        for (index, pass) in pipeline.passes.iter().enumerate() {
            for name in &pass.updates {
                if let Some(of) = makers.get_mut(name.value.as_str()) {
                    of.push(index);
                }
            }
        }
        Makers(makers)
    }

    fn makers(&self, name: &str) -> &[usize] {
        self.0.get(name.trim_end_matches(LAST)).map(Vec::as_slice).unwrap_or_default()
    }

    /// The passes that make what `pass` reads, in this frame or the last, each with the resource that says so.
    pub fn needs<'p>(&self, pipeline: &'p Pipeline, pass: usize) -> Vec<(usize, &'p Located<String>)> {
        let last = pipeline.passes[pass].reads.iter().filter(|name| name.value.ends_with(LAST));
        let last = last.flat_map(|name| self.makers(&name.value).iter().map(move |maker| (*maker, name)));
        self.before(pipeline, pass).into_iter().chain(last).collect()
    }

    /// The passes that must come before `pass`, each with the resource that says so.
    pub fn before<'p>(&self, pipeline: &'p Pipeline, pass: usize) -> Vec<(usize, &'p Located<String>)> {
        let entry = &pipeline.passes[pass];
        let makers = |name: &Located<String>| self.makers(&name.value);
        // What was there before the last writing is there already.
        let reads = entry.reads.iter().filter(|name| !name.value.ends_with(LAST));
        let reads = reads.flat_map(|name| makers(name).iter().map(move |maker| (*maker, name)));
        let updates = entry.updates.iter().flat_map(|name| {
            makers(name).iter().take_while(|maker| **maker != pass).map(move |maker| (*maker, name))
        });
        reads.chain(updates).collect()
    }
}

/// All passes such that each comes after those that it depends on, else in the file's order.
pub(crate) fn order(pipeline: &Pipeline, makers: &Makers<'_>) -> Result<Vec<usize>, Fault> {
    let mut done = Vec::new();
    let mut path = Vec::new();
    for pass in 0..pipeline.passes.len() {
        visit(pipeline, makers, pass, &mut done, &mut path)?;
    }
    Ok(done)
}

fn visit<'p>(
    pipeline: &'p Pipeline,
    makers: &Makers<'_>,
    pass: usize,
    done: &mut Vec<usize>,
    path: &mut Vec<(usize, Option<&'p Located<String>>)>,
) -> Result<(), Fault> {
    if done.contains(&pass) {
        return Ok(());
    }
    path.push((pass, None));
    for (before, name) in makers.before(pipeline, pass) {
        if let Some(top) = path.last_mut() {
            top.1 = Some(name);
        }
        if let Some(start) = path.iter().position(|(other, _)| *other == before) {
            return Err(cycle(pipeline, &path[start..]));
        }
        visit(pipeline, makers, before, done, path)?;
    }
    path.pop();
    done.push(pass);
    Ok(())
}

fn cycle(pipeline: &Pipeline, path: &[(usize, Option<&Located<String>>)]) -> Fault {
    let name = |index: usize| -> &PassEntry { &pipeline.passes[index] };
    let steps: Vec<String> = path
        .iter()
        .enumerate()
        .map(|(i, (pass, through))| {
            let next = path[(i + 1) % path.len()].0;
            let through = through.map(|name| name.value.as_str()).unwrap_or_default();
            format!("`{}` needs `{through}` from `{}`", name(*pass).name, name(next).name)
        })
        .collect();
    let first = name(path[0].0);
    pipeline
        .fault(&Some(first.span.clone()), "the passes form a cycle", "this pass waits for itself")
        .note(steps.join(", "))
}
