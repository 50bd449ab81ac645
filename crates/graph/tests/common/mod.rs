//! What the tests plan.
#![allow(dead_code, reason = "each test program uses its part")]

use glam::DVec3;
use voxlume_fault::Source;
use voxlume_graph::{Pipeline, Plan, Registry, Request, SceneFacts};

/// A pipeline with every kind of pass.
pub const PIPELINE: &str = include_str!("everything.ron");

/// A scene with everything in it; emission is in polygons unless told otherwise.
pub fn rich() -> SceneFacts {
    SceneFacts {
        bounds: Some((DVec3::ZERO, DVec3::new(4.0, 3.0, 2.0))),
        triangles: 1000,
        longest_edge: 1.0,
        vertices: 3000,
        materials: 5,
        directional: 1,
        point: 2,
        spot: 1,
        polygons: Some(2),
        emitters: Some(2),
        emission_max: 5.0,
        emissive: true,
        textured: true,
        texture_layers: [2, 1],
        texture_size: 256,
        masked: true,
        masked_triangles: [100, 0],
        glossy: true,
        polished: false,
        wide: 1,
        sky: true,
        moving_triangles: 100,
    }
}

/// `PIPELINE` with each first text, which must be there, replaced by the second.
pub fn with(changes: &[(&str, &str)]) -> String {
    let mut text = PIPELINE.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    text
}

/// A pipeline in a file called `p.ron`.
pub fn pipeline(text: &str) -> Pipeline {
    Pipeline::parse(&Source::new("p.ron", text)).unwrap_or_else(|faults| panic!("{faults}"))
}

/// An image of 64 × 48 pixels.
pub fn request() -> Request {
    Request::image(64, 48)
}

/// Plans with the built-in formats and shaders.
pub fn plan(
    pipeline: &Pipeline,
    facts: &SceneFacts,
    request: &Request,
) -> Result<Plan, voxlume_fault::Faults> {
    voxlume_graph::plan(pipeline, facts, &Registry::builtin(), request)
}

/// The message when `PIPELINE`, changed, is planned for the rich scene.
pub fn message(changes: &[(&str, &str)]) -> String {
    message_for(changes, &request())
}

/// The message for a request of one's own.
pub fn message_for(changes: &[(&str, &str)], request: &Request) -> String {
    match Pipeline::parse(&Source::new("p.ron", with(changes))).and_then(|p| plan(&p, &rich(), request)) {
        Ok(_) => "no fault".into(),
        Err(faults) => faults.to_string(),
    }
}
