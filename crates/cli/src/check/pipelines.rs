//! Pipelines planned in every way that matters, without a scene.

use glam::DVec3;
use voxlume::{Faults, Kinds, Pipeline, Registry, Request, SceneFacts, Value, plan};

/// Plans a pipeline with every format and every tracer for scenes that need all of it. A fault may come several times.
pub fn check(pipeline: &Pipeline, registry: &Registry) -> Faults {
    let mut faults = Faults::default();
    // The file's own words are checked as well.
    let base = Request { set: used(pipeline, &registry.kinds), ..Request::image(64, 64) };
    let formats = registry.formats.iter().map(|format| Some(format.name().to_owned()));
    let formats = formats.map(|format| Request { format, ..base.clone() });
    let tracers = registry.tracers.iter().map(|tracer| Some(tracer.name.to_owned()));
    let tracers = tracers.map(|tracer| Request { tracer, ..base.clone() });
    for request in std::iter::once(base.clone()).chain(formats).chain(tracers) {
        let mut planned =
            |request: &Request, facts: &SceneFacts| faults.gather(plan(pipeline, facts, registry, request));
        // What a plan lacks, as nobody reads it, is planned for its own sake.
        if let Some(whole) = planned(&request, &rich(Some(2), Some(2))) {
            let absent = pipeline
                .passes
                .iter()
                .filter(|pass| !whole.passes.iter().any(|other| other.name == pass.name));
            let images = registry.kinds.images(pipeline);
            let writes = absent.flat_map(|pass| &pass.writes);
            for image in writes.filter(|name| images.contains(&name.value.as_str())) {
                planned(
                    &Request { output: Some(image.value.clone()), ..request.clone() },
                    &rich(Some(2), Some(2)),
                );
            }
        }
        planned(&request, &rich(None, Some(200)));
        planned(&request, &rich(None, None));
    }
    faults
}

/// Passes that the file turns off are checked too.
fn used(pipeline: &Pipeline, kinds: &Kinds) -> Vec<(String, String, Value)> {
    let idle = pipeline.passes.iter().filter_map(|pass| Some((pass, kinds.idle(pass)?.unless)));
    idle.map(|(pass, (param, value))| (pass.name.clone(), param.to_owned(), Value::Number(value))).collect()
}

/// A scene with every feature. Its emission is so few polygons, or so many, or has to be gathered from voxels.
fn rich(polygons: Option<u32>, emitters: Option<u32>) -> SceneFacts {
    SceneFacts {
        bounds: Some((DVec3::ZERO, DVec3::ONE)),
        triangles: 1000,
        longest_edge: 1.0,
        vertices: 3000,
        materials: 4,
        directional: 1,
        point: 1,
        spot: 1,
        polygons,
        emitters,
        emissive: true,
        emission_max: 1.0,
        textured: true,
        texture_layers: [1, 2],
        texture_size: 64,
        masked: true,
        masked_triangles: [100, 0],
        glossy: true,
        polished: false,
        wide: 1,
        sky: true,
        moving_triangles: 100,
    }
}
