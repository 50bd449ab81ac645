//! From a pipeline to a plan.

use std::collections::BTreeSet;
use std::path::{Component, Path};

use voxlume_fault::{Fault, Faults, Source, suggest};
use voxlume_format::Formats;
use voxlume_shader::Library;

use crate::expand::voxel_view::VOLUME_CHANNELS;
use crate::expand::{self, Context, Expansion, Storage};
use crate::facts::SceneFacts;
use crate::grid::Grid;
use crate::kind::{KINDS, Kind, SURFACE_IMAGES};
use crate::limits;
use crate::order::{Makers, order};
use crate::pipeline::{Located, Param, PassEntry, Pipeline, Value};
use crate::plan::{LeftOut, Pass, Plan};
use crate::variant;

/// What is asked for beside the pipeline's file. Words that are given replace the file's.
#[derive(Clone, Debug)]
pub struct Request {
    /// Storage format with its options: `sh2:mip=projected`.
    pub format: Option<String>,
    /// Texel encoding with its options: `rgba8:range=8`.
    pub encoding: Option<String>,
    /// Voxels along the grid's longest side.
    pub resolution: Option<u32>,
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
            resolution: None,
            output: None,
            set: Vec::new(),
            screen,
            filters_float32: false,
            memory_budget: None,
        }
    }
}

/// Effects are made by a kind of their own, which has no word: `run` names the effect.
static EFFECT_KIND: Kind = Kind {
    name: "effect",
    sentence: "runs a cone-traced effect for every pixel",
    reads: &[],
    writes: &[],
    updates: &[],
    words: &[],
    expand: expand::screen::effect,
};

/// Plans a pipeline for a scene.
///
/// # Errors
/// Every fault of the pipeline, the request and the shaders, each with its place.
pub fn plan(
    pipeline: &Pipeline,
    facts: &SceneFacts,
    formats: &Formats,
    library: &Library,
    request: &Request,
) -> Result<Plan, Faults> {
    let mut faults = Faults::default();
    let mut pipeline = pipeline.clone();
    apply(&mut pipeline, request, &mut faults);
    let library = with_own_effects(&pipeline, library, &mut faults);
    let pipeline = &pipeline;

    let format = variant::format(pipeline, formats, &mut faults);
    let encoding = variant::encoding(pipeline, &mut faults);
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
    check_entries(pipeline, &library, &mut faults);
    let makers = Makers::of(pipeline, &mut faults);
    if !pipeline.passes.iter().any(|pass| makes(pass, &pipeline.output.value)) {
        let made: Vec<&str> = images(pipeline).collect();
        faults.push(unknown(pipeline, "output", &pipeline.output, &made));
    }
    let ordered = faults.gather(order(pipeline, &makers));
    let (Some((format, choices)), Some(encoding), Some(ordered), true) =
        (format, encoding, ordered, faults.is_empty())
    else {
        return Err(faults);
    };

    let area_lights = uses_area_lights(pipeline, facts);
    let grid = Grid::new(pipeline.resolution.value, pipeline.extent, facts.bounds);
    let storage = Storage::new(format, choices, encoding, request.filters_float32);
    let plan_format = storage.word();
    let mut context = Context::new(pipeline, facts, storage, grid, request.screen, library, area_lights);
    let live = live(pipeline, &makers, &mut context);
    let mut passes = Vec::new();
    for index in ordered.into_iter().filter(|index| live.contains(index)) {
        let entry = &pipeline.passes[index];
        let kind = kind_of(entry);
        let mut expansion = Expansion::new(&mut context, entry, kind);
        (kind.expand)(&mut expansion);
        let (once, steps) = expansion.finish();
        let words = |list: &[Located<String>]| list.iter().map(|name| name.value.clone()).collect::<Vec<_>>();
        let reads: Vec<String> =
            words(&entry.reads).into_iter().filter(|name| context.available.contains(name)).collect();
        let writes = [words(&entry.writes), words(&entry.updates)].concat();
        let parts = [
            (format!("{} static", entry.name), true, once),
            (entry.name.clone(), kind.name == "voxelize" && facts.moving_triangles == 0, steps),
        ];
        passes.extend(parts.map(|(name, once, steps)| Pass {
            name,
            once,
            reads: reads.clone(),
            writes: writes.clone(),
            steps,
        }));
    }
    passes.retain(|pass| !pass.steps.is_empty());
    explain_channels(&mut context);
    limits::check_resources(pipeline, &mut context);
    let output = context.resources.iter().position(|resource| resource.name == pipeline.output.value);
    if output.is_none() && context.faults.is_empty() {
        let name = &pipeline.output.value;
        let makes_it = |pass: &&PassEntry| makes(pass, name);
        let pass = pipeline.passes.iter().find(makes_it).map(|pass| format!("pass `{}`", pass.name));
        let why = context.left_out.iter().find(|item| Some(&item.what) == pass.as_ref());
        let why = why.map(|item| item.why.clone()).unwrap_or_default();
        let message = format!("this scene has no `{name}`");
        context.faults.push(pipeline.fault(&pipeline.output.span, message, why));
    }
    let Context { shaders, resources, left_out, faults, grid, .. } = context;
    let Some(output) = output.filter(|_| faults.is_empty()) else { return Err(faults) };
    let plan = Plan {
        format: plan_format,
        encoding,
        grid,
        screen: request.screen,
        triangles: facts.triangles,
        area_lights,
        shaders,
        resources,
        passes,
        left_out,
        output,
        memory_budget: request.memory_budget,
    };
    limits::check_budget(&plan, facts)?;
    Ok(plan)
}

/// Puts the request's words in place of the file's.
fn apply(pipeline: &mut Pipeline, request: &Request, faults: &mut Faults) {
    let replace = |word: &mut Located<String>, given: &Option<String>| {
        if let Some(value) = given {
            *word = Located { value: value.clone(), span: None };
        }
    };
    replace(&mut pipeline.format, &request.format);
    replace(&mut pipeline.encoding, &request.encoding);
    replace(&mut pipeline.output, &request.output);
    if let Some(value) = request.resolution {
        pipeline.resolution = Located { value, span: None };
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

fn unknown(pipeline: &Pipeline, what: &str, word: &Located<String>, choices: &[&str]) -> Fault {
    let message = format!("unknown {what} `{}`", word.value);
    pipeline.fault(&word.span, message, suggest(&word.value, choices.iter().copied()))
}

fn kind_of(entry: &PassEntry) -> &'static Kind {
    Kind::get(&entry.run.value).unwrap_or(&EFFECT_KIND)
}

/// Conditions for `when`.
const CONDITIONS: [&str; 4] = ["lights", "glossy", "shadow_mapped_lights", "gathered_light"];

fn holds(condition: &str, facts: &SceneFacts, area_lights: bool) -> bool {
    match condition {
        "lights" => facts.punctual() > 0 || (area_lights && facts.polygons.unwrap_or(0) > 0),
        "glossy" => facts.glossy,
        "shadow_mapped_lights" => facts.punctual() > 0,
        _ => facts.sky || (facts.emissive && !area_lights),
    }
}

fn why_not(condition: &str) -> &'static str {
    match condition {
        "lights" => "the scene has no light",
        "glossy" => "no material is glossy",
        "shadow_mapped_lights" => "the scene has no directional, spot or point light",
        _ => "no sky, and no emission but that of area lights",
    }
}

fn check_entries(pipeline: &Pipeline, library: &Library, faults: &mut Faults) {
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
fn check_ports(pipeline: &Pipeline, pass: &PassEntry, kind: &Kind, faults: &mut Faults) {
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

fn makes(pass: &PassEntry, image: &str) -> bool {
    let surface = pass.writes.iter().any(|name| name.value == "surface") && SURFACE_IMAGES.contains(&image);
    surface || (is_screen(pass) && pass.writes.iter().any(|name| name.value == image))
}

fn is_screen(pass: &PassEntry) -> bool {
    Kind::get(&pass.run.value).is_none_or(Kind::is_screen)
}

/// Every image that can be an output.
fn images(pipeline: &Pipeline) -> impl Iterator<Item = &str> {
    let screen = pipeline.passes.iter().filter(|pass| is_screen(pass)).flat_map(|pass| &pass.writes);
    let surface = pipeline.passes.iter().any(|pass| pass.writes.iter().any(|name| name.value == "surface"));
    screen.map(|name| name.value.as_str()).chain(SURFACE_IMAGES.into_iter().filter(move |_| surface))
}

/// Emissive polygons are lights of their own where they are few and the light pass doesn't say otherwise.
fn uses_area_lights(pipeline: &Pipeline, facts: &SceneFacts) -> bool {
    let gather = pipeline.passes.iter().filter(|pass| pass.run.value == "light").any(|pass| {
        pass.params
            .iter()
            .any(|param| param.name == "emission" && param.value == Value::Word("gather".into()))
    });
    facts.emissive && facts.polygons.is_some() && !gather
}

/// The passes that the output needs on this scene. What is left out is noted with its reason.
fn live(pipeline: &Pipeline, makers: &Makers<'_>, context: &mut Context<'_>) -> BTreeSet<usize> {
    let facts = context.facts;
    let mut skipped: Vec<(usize, String)> = Vec::new();
    for (index, pass) in pipeline.passes.iter().enumerate() {
        let number = |name: &str| pass.params.iter().find(|p| p.name == name).map(|p| &p.value);
        if let Some(when) = &pass.when
            && !holds(&when.value, facts, context.area_lights)
        {
            skipped.push((index, why_not(&when.value).to_owned()));
        } else if pass.run.value == "bounce" && number("bounces") == Some(&Value::Number(0.0)) {
            skipped.push((index, "`bounces` is 0".to_owned()));
        } else if pass.run.value == "shadow_maps" && casts_by_ray(pipeline) {
            skipped.push((index, "occlusion is by voxel ray".to_owned()));
        }
    }
    let wanted = |pass: &PassEntry| makes(pass, &pipeline.output.value);
    let mut stack: Vec<usize> =
        (0..pipeline.passes.len()).filter(|index| wanted(&pipeline.passes[*index])).collect();
    let mut live = BTreeSet::new();
    while let Some(index) = stack.pop() {
        if skipped.iter().any(|(skip, _)| *skip == index) || !live.insert(index) {
            continue;
        }
        let unread = unread_inputs(&pipeline.passes[index]);
        let before = makers.before(pipeline, index);
        stack.extend(
            before.iter().filter(|(_, name)| !unread.contains(&name.value.as_str())).map(|(maker, _)| *maker),
        );
    }
    for index in &live {
        let pass = &pipeline.passes[*index];
        context.available.extend(pass.writes.iter().map(|name| name.value.clone()));
        let surface = pass.reads.iter().any(|name| name.value == "surface") || !is_screen(pass);
        if surface && is_screen(pass) {
            context.surface_images.extend(["albedo", "normal", "geometry", "depth"]);
            if pass.run.value == "composite" && facts.emissive {
                context.surface_images.insert("emission");
            }
        }
    }
    context.surface_images.extend(SURFACE_IMAGES.iter().filter(|image| **image == pipeline.output.value));
    for (index, pass) in pipeline.passes.iter().enumerate().filter(|(index, _)| !live.contains(index)) {
        let why = skipped.iter().find(|(skip, _)| *skip == index).map(|(_, why)| why.clone());
        let unread = pipeline.passes.iter().filter(|other| other.run.value == "composite").any(|other| {
            unread_inputs(other).iter().any(|input| pass.writes.iter().any(|name| name.value == *input))
        });
        let why = why.unwrap_or_else(|| {
            if unread { "`ao_weight` is 0".to_owned() } else { "nobody reads what it makes".to_owned() }
        });
        context.left_out.push(LeftOut {
            what: format!("pass `{}`", pass.name),
            why,
            bytes: saved(pass, context),
        });
    }
    // What is made for another pass only is no input of this one.
    let reads = |pass: &PassEntry, input: &str| {
        pass.reads.iter().any(|name| name.value == input) && !unread_inputs(pass).contains(&input)
    };
    for input in live.iter().flat_map(|index| unread_inputs(&pipeline.passes[*index])) {
        if !live.iter().any(|index| reads(&pipeline.passes[*index], input)) {
            context.available.remove(*input);
        }
    }
    live
}

/// Inputs that a pass names and, by its parameters, never looks at.
fn unread_inputs(pass: &PassEntry) -> &'static [&'static str] {
    let given = |name: &str, is: &dyn Fn(&Value) -> bool| {
        pass.params.iter().any(|param| param.name == name && is(&param.value))
    };
    let volume =
        |value: &Value| matches!(value, Value::Word(word) if VOLUME_CHANNELS.contains(&word.as_str()));
    match pass.run.value.as_str() {
        "composite" if given("ao_weight", &|value| *value == Value::Number(0.0)) => &["ao"],
        "voxel_view" if !given("channel", &volume) => &["volume"],
        _ => &[],
    }
}

fn casts_by_ray(pipeline: &Pipeline) -> bool {
    let mut lights = pipeline.passes.iter().filter(|pass| pass.run.value == "light");
    lights.all(|pass| {
        pass.params.iter().any(|p| p.name == "occlusion" && p.value == Value::Word("voxel_ray".into()))
    })
}

/// Bytes of what a pass would have made.
fn saved(pass: &PassEntry, context: &Context<'_>) -> u64 {
    let [width, height] = context.screen.map(u64::from);
    let image = 8 * width * height;
    let layers = if pass.layers.is_some() { u64::from(context.light_count().div_ceil(4)) } else { 1 };
    if is_screen(pass) { image * layers * pass.writes.len() as u64 } else { 0 }
}

/// Channels and branches that the scene doesn't need.
fn explain_channels(context: &mut Context<'_>) {
    let facts = context.facts;
    let [width, height] = context.screen.map(u64::from);
    let mut left_out = Vec::new();
    let mut note = |absent: bool, what: &str, why: &str, bytes: u64| {
        if absent {
            left_out.push(LeftOut { what: what.into(), why: why.into(), bytes });
        }
    };
    let inside = facts.bounds.is_none_or(|bounds| context.grid.holds(bounds));
    note(!inside, "what lies outside the grid", "the pipeline gives the grid's corners", 0);
    note(!facts.emissive, "emission image", "no material emits", 8 * width * height);
    let why = if facts.emissive { "what emits is lit as area lights" } else { "no material emits" };
    note(!context.voxel_emission(), "emission in voxels (12 bytes each)", why, 0);
    note(!facts.masked, "alpha tests", "no material has an alpha mask", 0);
    note(!facts.textured, "texture look-ups", "no material has a texture", 0);
    note(facts.directional == 0, "directional lights' branch", "the scene has none", 0);
    note(facts.point == 0, "point lights' branch", "the scene has none", 0);
    note(facts.spot == 0, "spot lights' branch", "the scene has none", 0);
    note(!context.area_lights, "area lights' branch", "no emissive polygon is lit as one", 0);
    let still = facts.triangles - facts.moving_triangles;
    match facts.moving_triangles {
        0 => note(true, "voxelizing every frame", "nothing moves", 0),
        _ => note(still > 0, &format!("voxelizing {still} triangles every frame"), "they never move", 0),
    }
    context.left_out.extend(left_out);
}
