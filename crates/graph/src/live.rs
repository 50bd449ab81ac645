//! What of a pipeline a scene needs, and why the rest is left out.

use std::collections::BTreeSet;

use crate::entries::{is_screen, makes};
use crate::expand::Context;
use crate::expand::voxel_view::VOLUME_CHANNELS;
use crate::facts::SceneFacts;
use crate::kind::SURFACE_IMAGES;
use crate::order::Makers;
use crate::pipeline::{PassEntry, Pipeline, Value};
use crate::plan::LeftOut;

/// Conditions for `when`.
pub(crate) const CONDITIONS: [&str; 4] = ["lights", "glossy", "shadow_mapped_lights", "gathered_light"];

pub(crate) fn holds(condition: &str, facts: &SceneFacts, area_lights: bool) -> bool {
    match condition {
        "lights" => facts.punctual() > 0 || (area_lights && facts.polygons.unwrap_or(0) > 0),
        "glossy" => facts.glossy,
        "shadow_mapped_lights" => facts.punctual() > 0,
        _ => facts.sky || (facts.emissive && !area_lights),
    }
}

pub(crate) fn why_not(condition: &str) -> &'static str {
    match condition {
        "lights" => "the scene has no light",
        "glossy" => "no material is glossy",
        "shadow_mapped_lights" => "the scene has no directional, spot or point light",
        _ => "no sky, and no emission but that of area lights",
    }
}

/// The passes that the output needs on this scene. What is left out is noted with its reason.
pub(crate) fn live(pipeline: &Pipeline, makers: &Makers<'_>, context: &mut Context<'_>) -> BTreeSet<usize> {
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
pub(crate) fn unread_inputs(pass: &PassEntry) -> &'static [&'static str] {
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

pub(crate) fn casts_by_ray(pipeline: &Pipeline) -> bool {
    let mut lights = pipeline.passes.iter().filter(|pass| pass.run.value == "light");
    lights.all(|pass| {
        pass.params.iter().any(|p| p.name == "occlusion" && p.value == Value::Word("voxel_ray".into()))
    })
}

/// Bytes of what a pass would have made.
pub(crate) fn saved(pass: &PassEntry, context: &Context<'_>) -> u64 {
    let [width, height] = context.screen.map(u64::from);
    let image = 8 * width * height;
    let layers = if pass.layers.is_some() { u64::from(context.light_count().div_ceil(4)) } else { 1 };
    if is_screen(pass) { image * layers * pass.writes.len() as u64 } else { 0 }
}

/// Channels and branches that the scene doesn't need.
pub(crate) fn explain_channels(context: &mut Context<'_>) {
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
