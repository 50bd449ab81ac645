//! From a pipeline to a plan.

use std::path::{Component, Path};

use voxlume_fault::{Fault, Faults, Source, suggest};
use voxlume_shader::Library;

use crate::bundle::Bundle;
use crate::entries::{check_entries, images, makes, sorts};
use crate::expansion::context::Given;
use crate::expansion::{Context, Expanded, Expansion, LAST};
use crate::facts::SceneFacts;
use crate::flow::Flow;
use crate::grid::Grid;
use crate::limits;
use crate::live::{emission_of, explain_branches, live};
use crate::order::{Makers, order};
use crate::pass::{Kinds, Sort};
use crate::pipeline::{Located, Param, PassEntry, Pipeline, SCALES, Value, scales};
use crate::plan::{Pass, Plan, Target};
use crate::prune::prune;
use crate::registry::Registry;
use crate::storage::Storage;
use crate::{tracer, variant};

/// What is asked for beside the pipeline's file. Words that are given replace the file's.
#[derive(Clone, Debug)]
pub struct Request {
    /// Storage format with its options: `sh2:mip=projected`.
    pub format: Option<String>,
    /// Texel encoding with its options: `rgba8:range=8`.
    pub encoding: Option<String>,
    /// Tracer of passes that name none.
    pub tracer: Option<String>,
    /// Voxels along the grid's longest side.
    pub resolution: Option<u32>,
    /// What the screen's size is divided by where effects that trace gather: one of [`SCALES`].
    pub scale: Option<u32>,
    /// The image to make.
    pub output: Option<String>,
    /// Parameters: pass, name, value.
    pub set: Vec<(String, String, Value)>,
    /// Width and height of the image in pixels.
    pub screen: [u32; 2],
    /// Whether the device can filter textures of 32-bit floats.
    pub filters_float32: bool,
    /// Bytes that the plan may take on the device; `None` for as many as there are.
    pub memory_budget: Option<u64>,
}

impl Request {
    /// An image of this size, everything else as the pipeline's file says.
    pub fn image(width: u32, height: u32) -> Request {
        let screen = [width, height];
        Request {
            format: None,
            encoding: None,
            tracer: None,
            resolution: None,
            scale: None,
            output: None,
            set: Vec::new(),
            screen,
            filters_float32: false,
            memory_budget: None,
        }
    }
}

/// Plans a pipeline for a scene.
///
/// # Errors
/// Every fault of the pipeline, the request and the shaders, each with its place.
pub fn plan(
    pipeline: &Pipeline,
    facts: &SceneFacts,
    registry: &Registry,
    request: &Request,
) -> Result<Plan, Faults> {
    let mut faults = Faults::default();
    let mut pipeline = pipeline.clone();
    let Registry { formats, encodings, kinds, tracers, library } = registry;
    apply(&mut pipeline, request, kinds, &mut faults);
    let library = with_own_effects(&pipeline, library, &mut faults);
    tracer::resolve(&mut pipeline, kinds, tracers, &mut faults);
    let pipeline = &pipeline;

    let format = variant::format(pipeline, &pipeline.format, formats, &mut faults);
    let encoding = variant::encoding(pipeline, &pipeline.encoding, encodings, &mut faults);
    if !["conservative", "thin"].contains(&pipeline.separability.value.as_str()) {
        faults.push(unknown(pipeline, "separability", &pipeline.separability, &["conservative", "thin"]));
    }
    let resolution = &pipeline.resolution;
    if !Grid::RESOLUTIONS.contains(&resolution.value) {
        let label = Grid::resolution_range();
        let message = format!("a grid of {0} × {0} × {0} voxels", resolution.value);
        faults.push(pipeline.fault(&resolution.span, message, label));
    }
    limits::check_screen(request.screen, &mut faults);
    check_entries(pipeline, kinds, &library, &mut faults);
    let makers = Makers::of(pipeline, kinds, &mut faults);
    if !pipeline.passes.iter().any(|pass| makes(kinds, pass, &pipeline.output.value)) {
        faults.push(unknown(pipeline, "output", &pipeline.output, &images(pipeline, kinds)));
    }
    let ordered = faults.gather(order(pipeline, &makers));
    let (Some((format, choices)), Some(encoding), Some(ordered), true) =
        (format, encoding, ordered, faults.is_empty())
    else {
        return Err(faults);
    };

    let emission = emission_of(pipeline, facts, kinds, tracers);
    let grid = Grid::new(pipeline.resolution.value, pipeline.extent, facts.bounds);
    let filters_float32 = request.filters_float32;
    let storage = Storage::new(format, choices, encoding, filters_float32);
    let plan_format = storage.word();
    let screen = request.screen;
    let given = Given {
        pipeline,
        facts,
        kinds,
        formats,
        encodings,
        tracers,
        library: &library,
        screen,
        filters_float32,
    };
    let mut context = Context::new(given, storage, grid, emission);
    let live = live(pipeline, &makers, &mut context);
    context.check_tracers();
    if !context.faults.is_empty() {
        return Err(context.faults);
    }
    let mut passes = Vec::new();
    for index in ordered.into_iter().filter(|index| live.contains(index)) {
        let entry = &pipeline.passes[index];
        let mut expansion = Expansion::new(&mut context, entry);
        kinds.of(entry).expand(&mut expansion);
        passes.extend(finished(entry, expansion.finish(), &context));
    }
    explain_branches(&mut context);
    let kept = [context.levels.as_mut_slice(), context.out_of_range.as_mut_slice()];
    prune(&mut passes, &mut context.resources, kept, &pipeline.output.value);
    limits::check_resources(pipeline, &mut context);
    let output = context.resources.iter().position(|resource| resource.name == pipeline.output.value);
    if output.is_none() && context.faults.is_empty() {
        let name = &pipeline.output.value;
        let makes_it = |pass: &&PassEntry| makes(kinds, pass, name);
        let pass = pipeline.passes.iter().find(makes_it).map(|pass| format!("pass `{}`", pass.name));
        let why = context.left_out.iter().find(|item| Some(&item.what) == pass.as_ref());
        let why = why.map(|item| item.why.clone()).unwrap_or_default();
        let message = format!("this scene has no `{name}`");
        context.faults.push(pipeline.fault(&pipeline.output.span, message, why));
    }
    let Context { shaders, resources, left_out, faults, mut grids, levels, out_of_range, .. } = context;
    let Some(output) = output.filter(|_| faults.is_empty()) else { return Err(faults) };
    let plan = Plan {
        format: plan_format,
        encoding,
        tracer: pipeline.tracer.value.clone(),
        grid: grids.swap_remove(0),
        screen,
        triangles: facts.triangles,
        emission,
        shaders,
        resources,
        passes,
        left_out,
        output,
        levels,
        out_of_range,
        memory_budget: request.memory_budget,
    };
    limits::check_budget(&plan, facts)?;
    Ok(plan)
}

/// Puts the request's words in place of the file's.
fn apply(pipeline: &mut Pipeline, request: &Request, kinds: &Kinds, faults: &mut Faults) {
    let replace = |word: &mut Located<String>, given: &Option<String>| {
        if let Some(value) = given {
            *word = Located { value: value.clone(), span: None };
        }
    };
    replace(&mut pipeline.format, &request.format);
    replace(&mut pipeline.encoding, &request.encoding);
    replace(&mut pipeline.tracer, &request.tracer);
    replace(&mut pipeline.output, &request.output);
    if let Some(value) = request.resolution {
        pipeline.resolution = Located { value, span: None };
    }
    if let Some(value) = request.scale {
        if !SCALES.contains(&value) {
            faults.push(Fault::new(format!("unknown scale `{value}`")).note(scales()));
        } else {
            let sorts = sorts(pipeline, kinds);
            let traces = |entry: &PassEntry| {
                let is_volume = |name: &Located<String>| sorts.get(&name.value) == Some(&Sort::VOLUME);
                entry.is_effect() && entry.reads.iter().any(is_volume)
            };
            for entry in pipeline.passes.iter_mut().filter(|entry| traces(entry)) {
                entry.scale = Located { value, span: None };
                entry.full_size_when = None;
            }
        }
    }
    for (pass, name, value) in &request.set {
        let known: Vec<String> = pipeline.passes.iter().map(|entry| entry.name.clone()).collect();
        let Some(entry) = pipeline.passes.iter_mut().find(|entry| entry.name == *pass) else {
            let label = suggest(pass, known.iter().map(String::as_str));
            faults.push(Fault::new(format!("no pass is called `{pass}`")).note(label));
            continue;
        };
        entry.params.retain(|param| param.name != *name);
        entry.params.push(Param { name: name.clone(), name_span: None, value: value.clone(), span: None });
    }
}

/// The library and the pipeline's own effect files, which lie beside it.
fn with_own_effects(pipeline: &Pipeline, library: &Library, faults: &mut Faults) -> Library {
    let mut library = library.clone();
    let folder = Path::new(&pipeline.source.name).parent().map(Path::to_path_buf).unwrap_or_default();
    for run in pipeline.passes.iter().map(|pass| &pass.run).filter(|run| run.value.ends_with(".wgsl")) {
        let path = Path::new(&run.value);
        if !path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)) {
            let label = "a path below the pipeline's folder";
            faults.push(pipeline.fault(&run.span, "an effect's file outside the pipeline's folder", label));
            continue;
        }
        match Source::read(&folder.join(path)) {
            Ok(source) => library.insert(run.value.trim_end_matches(".wgsl"), source),
            Err(fault) => faults.push(pipeline.fault(&run.span, fault.message, "")),
        }
    }
    library
}

pub(crate) fn unknown(pipeline: &Pipeline, what: &str, word: &Located<String>, choices: &[&str]) -> Fault {
    let message = format!("unknown {what} `{}`", word.value);
    pipeline.fault(&word.span, message, suggest(&word.value, choices.iter().copied()))
}

/// The passes that an entry becomes: what has to be done only once, and the rest.
fn finished(entry: &PassEntry, expanded: Expanded, context: &Context<'_>) -> Vec<Pass> {
    let Expanded { once, steps, params } = expanded;
    let written = |name: &&Located<String>| context.bundles.contains_key(name.value.trim_end_matches(LAST));
    let words = |name: &Located<String>| name.value.clone();
    let reads: Vec<String> = entry.reads.iter().filter(written).map(words).collect();
    let writes: Vec<String> = entry.writes.iter().chain(&entry.updates).map(words).collect();
    let parts =
        [(format!("{} static", entry.name), once, vec![], true), (entry.name.clone(), steps, params, false)];
    let parts = parts.into_iter().filter(|(_, steps, ..)| !steps.is_empty());
    parts
        .map(|(name, steps, params, never_moves)| {
            let Flow { mut sources, inputs, outputs } =
                Flow::of(&steps, &context.shaders, &context.resources, &params);
            sources.geometry &= context.facts.moving_triangles > 0 && !never_moves;
            let (reads, writes, update) = (reads.clone(), writes.clone(), entry.update);
            let has_input = |name: &str| {
                let bundle = context.bundles.get(name.trim_end_matches(LAST));
                let mut parts = bundle.into_iter().flat_map(Bundle::parts);
                parts.any(|(_, target)| matches!(target, Target::Resource(index) if inputs.contains(index)))
            };
            let named = entry.reads.iter().chain(&entry.updates).map(words);
            let waits_for = named.filter(|name| has_input(name)).collect();
            Pass { name, reads, writes, steps, sources, inputs, waits_for, outputs, update, params }
        })
        .collect()
}
