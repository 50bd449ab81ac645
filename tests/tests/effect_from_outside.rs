//! A new effect is a WGSL file and an entry in a pipeline: no Rust.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Formats, Pipeline, Request, Value};
use voxlume_tests::{built_in, picture, render, root};

/// How thick what is behind the surface is: a trace into it.
const THICKNESS: &str = "
import package::common::surface::Surface;
import package::common::trace::{Apex, cone_lobe, reach_of};
import package::tracer::trace::trace_opacity;

struct Params {
    /// Full angle of the cone, (0, 3.1416].
    aperture: f32,
    /// How far it looks, voxels, (0, 1000].
    depth: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let inwards = -surface.normal_geometric;
    let apex = Apex(surface.position_voxel, inwards, surface.share);
    let opacity = trace_opacity(apex, cone_lobe(inwards, sin(params.aperture / 2.0)), reach_of(params.depth), 0.0);
    return vec4f(vec3f(opacity), 1.0);
}
";

/// Its entry, put before all others of `pipelines/gi.ron`.
const ENTRY: &str = r#"passes: [
        (run: "mine/thickness.wgsl", reads: ["surface", "volume"], writes: ["thickness"], shows: "share", params: (aperture_deg: 40, depth: 12)),"#;

#[test]
fn an_effect_from_a_file_runs_with_every_format() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("mine")).unwrap();
    std::fs::write(folder.path().join("mine/thickness.wgsl"), THICKNESS).unwrap();
    let file = folder.path().join("thickness.ron");
    let gi = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    assert!(gi.contains("passes: ["));
    std::fs::write(&file, gi.replacen("passes: [", ENTRY, 1)).unwrap();
    let pipeline = Pipeline::load(&file).unwrap();
    let scene = built_in("lights.ron");
    for format in Formats::builtin().iter() {
        let mean = |depth: Option<f64>| {
            let set = depth.map(|depth| ("thickness".into(), "depth".into(), Value::Number(depth)));
            let request = Request {
                format: Some(format.name().into()),
                resolution: Some(32),
                output: Some("thickness".into()),
                set: set.into_iter().collect(),
                ..Request::image(24, 16)
            };
            let picture = picture(&render(&pipeline, &scene, &request), "thickness");
            assert!(picture.pixels.iter().flatten().all(|value| value.is_finite()), "{}", format.name());
            let of = |pick: fn(f32, f32) -> f32| picture.pixels.iter().map(|p| p[0]).reduce(pick).unwrap();
            let (low, high) = (of(f32::min), of(f32::max));
            println!("{}: from {low} to {high}", format.name());
            assert!(low >= 0.0 && high <= 1.0 && high - low > 0.1, "{}: {low} to {high}", format.name());
            picture.pixels.iter().map(|p| f64::from(p[0])).sum::<f64>() / picture.pixels.len() as f64
        };
        // The parameter arrives.
        assert!((mean(None) - mean(Some(6.0))).abs() > 1e-3, "{}", format.name());
    }
}
