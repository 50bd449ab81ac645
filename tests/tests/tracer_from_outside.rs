//! A new tracer is WGSL and a description, and one word of a pipeline or of a pass changes to it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{CONES, Passes, Pipeline, Registry, Renderer, Request, SceneFacts, Sort, Source, Tracer, plan};
use voxlume_tests::{built_in, gpu, root};

/// Rays through the bitmask, which tell what is open and gather nothing.
const FEELERS: &str = "
import package::common::ray::ray_between;
import package::common::trace::{Apex, Gathered, Lobe, Reach};
import package::walk::first_hit;

struct TraceParams {
    /// How far over the surface a ray begins, voxels, [0, 8]; 2 unless given.
    lift: f32,
}

var<uniform> trace_params: TraceParams;

fn trace_opacity(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32) -> f32 {
    let origin = apex.position + trace_params.lift * apex.normal;
    return select(0.0, 1.0, first_hit(ray_between(origin, lobe.axis, reach.distance - 2.0 * trace_params.lift)).found);
}

fn trace_gather(apex: Apex, lobe: Lobe, reach: Reach) -> Gathered {
    return Gathered(vec3f(0.0), trace_opacity(apex, lobe, reach, 0.0), 0.0, vec3f(0.0), false);
}
";

fn registry() -> Registry {
    let mut registry = Registry::builtin();
    registry.tracers.add(Tracer {
        name: "feelers",
        summary: "rays through the bitmask",
        modules: "tracer/feelers",
        reads: &[Sort::VOXELS],
        samples: false,
    });
    registry.library.insert("tracer/feelers/trace", Source::new("feelers.wgsl", FEELERS));
    registry
}

/// `pipelines/gi.ron` with this word in its head, and this one in ambient occlusion's entry.
fn gi(pipeline: &str, pass: &str) -> Pipeline {
    let text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    let entry = "run: \"effect/ambient_occlusion\",";
    let head = "    tracer: \"rays\",\n";
    assert!(text.contains(entry) && text.contains("resolution: 128") && text.contains(head));
    let text = text.replace(head, "");
    let word = |word: &str| if word.is_empty() { String::new() } else { format!("tracer: \"{word}\", ") };
    let text = text.replace("resolution: 128", &format!("{}resolution: 32", word(pipeline)));
    Pipeline::parse(&Source::new("gi.ron", text.replace(entry, &format!("{entry} {}", word(pass))))).unwrap()
}

/// The mean openness of the Cornell box.
fn openness(pipeline: &Pipeline, tracer: Option<&str>) -> f64 {
    let scene = built_in("cornell.ron");
    let tracer = tracer.map(str::to_owned);
    let request = Request { output: Some("ao".into()), tracer, ..Request::image(24, 24) };
    let plan = plan(pipeline, &SceneFacts::of(&scene).unwrap(), &registry(), &request).unwrap();
    let mut renderer = Renderer::new(gpu(), plan, &scene).unwrap();
    renderer.render(&scene, &scene.cameras[0], Passes::All).unwrap();
    let picture = renderer.picture("ao").unwrap();
    picture.pixels.iter().map(|pixel| f64::from(pixel[0])).sum::<f64>() / picture.pixels.len() as f64
}

#[test]
fn one_word_changes_the_tracer_and_the_word_of_a_pass_wins() {
    let (cones, feelers) = (openness(&gi("cones", ""), None), openness(&gi("feelers", ""), None));
    assert_ne!(cones, feelers);
    for (pipeline, pass, request, expected) in [
        ("cones", "", None, cones),
        ("", "feelers", None, feelers),
        ("feelers", "cones", None, cones),
        ("cones", "", Some("feelers"), feelers),
        ("", "cones", Some("feelers"), cones),
    ] {
        assert_eq!(openness(&gi(pipeline, pass), request), expected, "{pipeline} {pass} {request:?}");
    }
}

/// The whole pipeline is planned as it is; what only cones choose is no fault, and what nobody does is one.
#[test]
fn entries_stay_as_they_are() {
    let facts = SceneFacts::of(&built_in("lights.ron")).unwrap();
    let request = |tracer: &str| Request { tracer: Some(tracer.into()), ..Request::image(8, 8) };
    let pipeline = gi("", "");
    let reads = |tracer: &str| {
        let plan = plan(&pipeline, &facts, &registry(), &request(tracer)).unwrap();
        plan.passes.iter().find(|pass| pass.name == "diffuse").unwrap().reads.clone()
    };
    assert_eq!(reads(CONES.name), ["surface", "volume"]);
    assert_eq!(reads("feelers"), ["surface", "voxels"]);
    let mut text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    text = text
        .replace("stepper: \"doubling\", step: 1.0, start: 1.0, ring: 2)", "steps: 2, start: 1.0, ring: 2)");
    let pipeline = Pipeline::parse(&Source::new("gi.ron", text)).unwrap();
    let faults = plan(&pipeline, &facts, &registry(), &request("feelers")).unwrap_err().to_string();
    assert!(faults.starts_with("error: pass `diffuse` has no parameter `steps`"), "{faults}");
}

/// A tracer that lacks a function is told which, once, however many passes trace.
#[test]
fn a_missing_function_is_named_with_its_signature() {
    let mut registry = registry();
    let text = FEELERS.replace("fn trace_gather(", "fn trace_gathers(");
    registry.library.insert("tracer/feelers/trace", Source::new("feelers.wgsl", text));
    let facts = SceneFacts::of(&built_in("cornell.ron")).unwrap();
    let request = Request { tracer: Some("feelers".into()), ..Request::image(8, 8) };
    let faults = plan(&gi("", ""), &facts, &registry, &request).unwrap_err().to_string();
    let message = "error: tracer `feelers` must have `fn trace_gather(apex: Apex, lobe: Lobe, reach: Reach) -> Gathered`";
    assert!(faults.starts_with(message) && faults.matches("error: ").count() == 1, "{faults}");
}
