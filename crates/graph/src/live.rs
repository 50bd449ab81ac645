//! What of a pipeline a scene needs, and why the rest is left out.

use std::collections::BTreeSet;

use crate::entries::{is_image, makes};
use crate::expansion::Context;
use crate::expansion::context::read_of;
use crate::facts::{Emission, SceneFacts};
use crate::order::Makers;
use crate::pass::Kinds;
use crate::pipeline::{Located, PassEntry, Pipeline};
use crate::plan::LeftOut;
use crate::tracer::Tracers;

/// A condition for `when`: its word, why it doesn't hold, and whether it does.
type Condition = (&'static str, &'static str, fn(&SceneFacts, Emission) -> bool);

/// Conditions for `when`; each is asked with how emission reaches others.
pub(crate) const CONDITIONS: [Condition; 6] = [
    ("lights", "the scene has no light", |facts, emission| {
        facts.punctual() > 0 || (emission == Emission::AreaLights && facts.polygons.unwrap_or(0) > 0)
    }),
    ("wide_lights", "every light's shadow map says how soft its shadows are", |facts, emission| {
        facts.wide > 0 || (emission == Emission::AreaLights && facts.polygons.unwrap_or(0) > 0)
    }),
    ("glossy", "no material is glossy", |facts, _| facts.glossy),
    ("polished", "no material is polished", |facts, _| facts.polished),
    ("shadow_mapped_lights", "the scene has no directional, spot or point light", |facts, _| {
        facts.punctual() > 0
    }),
    ("gathered_light", "no sky, and no emission but that of lights", |facts, emission| {
        facts.sky || (facts.emissive && emission == Emission::Gathered)
    }),
];

/// The condition of a word that has been checked.
fn condition(word: Option<&Located<String>>) -> Option<&'static Condition> {
    CONDITIONS.iter().find(|(known, ..)| word.is_some_and(|word| word.value == *known))
}

/// An entry's `scale`: 1 where the scene has what needs the image at full size.
pub(crate) fn scale_of(entry: &PassEntry, facts: &SceneFacts, emission: Emission) -> u32 {
    let full = condition(entry.full_size_when.as_ref()).is_some_and(|(_, _, holds)| holds(facts, emission));
    if full { 1 } else { entry.scale.value }
}

/// Why an entry has nothing to do in this scene, if so.
fn idle(entry: &PassEntry, context: &Context<'_>) -> Option<String> {
    let unmet =
        condition(entry.when.as_ref()).filter(|(_, _, holds)| !holds(context.facts, context.emission));
    let idle = || context.kinds.idle(entry).map(|idle| idle.why);
    unmet.map(|(_, why, _)| *why).or_else(idle).map(str::to_owned)
}

/// The passes that the output needs on this scene. What is left out is noted with its reason.
pub(crate) fn live(pipeline: &Pipeline, makers: &Makers<'_>, context: &mut Context<'_>) -> BTreeSet<usize> {
    let skipped: Vec<Option<String>> = pipeline.passes.iter().map(|entry| idle(entry, context)).collect();
    let mut stack: Vec<usize> = (0..pipeline.passes.len())
        .filter(|index| makes(context.kinds, &pipeline.passes[*index], &pipeline.output.value))
        .collect();
    let mut live = BTreeSet::new();
    while let Some(index) = stack.pop() {
        if skipped[index].is_some() || !live.insert(index) {
            continue;
        }
        let unread = unread(&pipeline.passes[index], context);
        let needs = makers.needs(pipeline, index);
        stack.extend(needs.iter().filter(|(_, name)| !unread.contains(&name.value)).map(|(maker, _)| *maker));
    }
    context.live = live.iter().map(|index| pipeline.passes[*index].name.clone()).collect();
    for (index, entry) in pipeline.passes.iter().enumerate().filter(|(index, _)| !live.contains(index)) {
        let why = skipped[index].clone().or_else(|| why_unread(pipeline, entry, context));
        let why = why.unwrap_or_else(|| "nobody reads what it makes".to_owned());
        let left_out = LeftOut { what: format!("pass `{}`", entry.name), why, bytes: saved(entry, context) };
        context.left_out.push(left_out);
    }
    live
}

/// Names that an entry reads and, by its parameters, never looks at.
fn unread(entry: &PassEntry, context: &Context<'_>) -> Vec<String> {
    let kind = context.kinds.of(entry);
    let ports = kind.unread(entry, context.tracers.of(context.pipeline, entry)).iter();
    ports.filter_map(|unread| context.read_of(entry, kind, unread.port)).map(str::to_owned).collect()
}

/// Why those who read what an entry makes don't look at it, if they say so.
fn why_unread(pipeline: &Pipeline, entry: &PassEntry, context: &Context<'_>) -> Option<String> {
    pipeline.passes.iter().find_map(|reader| {
        let kind = context.kinds.of(reader);
        let made = |name: &str| entry.writes.iter().any(|write| write.value == name);
        let unread = kind.unread(reader, context.tracers.of(pipeline, reader)).iter();
        let mut of_entry =
            unread.filter(|unread| read_of(&context.sorts, reader, kind, unread.port).is_some_and(made));
        of_entry.next().map(|unread| unread.why.to_owned())
    })
}

/// Bytes of the images that a pass would have made.
fn saved(entry: &PassEntry, context: &Context<'_>) -> u64 {
    if !is_image(context.kinds, entry) {
        return 0;
    }
    let [width, height] = entry.image.extent.size(context.screen).map(u64::from);
    let layers = if entry.layers.is_some() { u64::from(context.light_count().div_ceil(4)) } else { 1 };
    entry.image.texel.bytes() * width * height * layers * entry.writes.len() as u64
}

/// How emission reaches others: by polygons, unless an entry asks that all is gathered; many are asked only with tracers that walk
/// voxels, as what others sample holds emission.
pub(crate) fn emission_of(
    pipeline: &Pipeline,
    facts: &SceneFacts,
    kinds: &Kinds,
    tracers: &Tracers,
) -> Emission {
    let gathers = pipeline.passes.iter().any(|entry| kinds.of(entry).gathers_all_emission(entry));
    let traces = pipeline.passes.iter().filter(|entry| kinds.of(entry).traces());
    let walk = || traces.clone().all(|entry| tracers.of(pipeline, entry).walks());
    match facts {
        _ if gathers || !facts.emissive => Emission::Gathered,
        SceneFacts { polygons: Some(_), .. } => Emission::AreaLights,
        SceneFacts { emitters: Some(_), .. } if walk() => Emission::Sampled,
        _ => Emission::Gathered,
    }
}

/// Branches of shaders that the scene doesn't need.
pub(crate) fn explain_branches(context: &mut Context<'_>) {
    let facts = context.facts;
    let inside = facts.bounds.is_none_or(|bounds| context.grids[0].holds(bounds));
    let notes = [
        (!inside, "what lies outside the grid", "the pipeline gives the grid's corners"),
        (!facts.masked, "alpha tests", "no material has an alpha mask"),
        (!facts.textured, "texture look-ups", "no material has a texture"),
        (facts.directional == 0, "directional lights' branch", "the scene has none"),
        (facts.point == 0, "point lights' branch", "the scene has none"),
        (facts.spot == 0, "spot lights' branch", "the scene has none"),
        (
            context.emission != Emission::AreaLights,
            "area lights' branch",
            "no emissive polygon is lit as one",
        ),
    ];
    let notes = notes.into_iter().filter(|(absent, ..)| *absent);
    context.left_out.extend(notes.map(|(_, what, why)| LeftOut {
        what: what.into(),
        why: why.into(),
        bytes: 0,
    }));
}
