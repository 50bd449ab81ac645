//! Effects in files beside the pipeline.

use insta::assert_snapshot;
use voxlume_graph::Pipeline;

use crate::common::{message, plan, request, rich, with};

const EFFECT: &str = "import package::common::surface::Surface;

struct Params {
    /// Contrast, [0, 4].
    gain: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    return vec4f(surface.normal * params.gain, 1.0);
}
";

/// The message when the effect, with `from` replaced by `to`, is used in place of the diffuse one.
fn message_of(from: &str, to: &str, params: &str) -> String {
    assert!(EFFECT.contains(from), "{from}");
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mine.wgsl"), EFFECT.replace(from, to)).unwrap();
    let text = with(&[
        ("run: \"effect/diffuse\"", "run: \"mine.wgsl\""),
        ("\"surface\", \"volume\"],\n            writes: [\"diffuse\"]", "\"surface\"],\n            writes: [\"diffuse\"]"),
        ("stepper: \"spheres\", step: 0.5, start: 1.0", params),
    ]);
    let file = folder.path().join("p.ron");
    std::fs::write(&file, text).unwrap();
    let pipeline = Pipeline::load(&file).unwrap();
    match plan(&pipeline, &rich(), &request()) {
        Ok(_) => "no fault".into(),
        // The folder's name is another every time.
        Err(faults) => faults.to_string().replace(folder.path().to_str().unwrap(), "FOLDER"),
    }
}

#[test]
fn unchanged_it_has_no_fault() {
    assert_eq!(message_of("gain", "gain", "gain: 1.0"), "no fault");
}

#[test]
fn missing_file() {
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"mine/thickness.wgsl"#)]), @"");
}

#[test]
fn outside_the_folder() {
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"../diffuse.wgsl"#)]), @"");
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"/etc/diffuse.wgsl"#)]), @"");
}

#[test]
fn a_typo() {
    assert_snapshot!(message_of("surface.normal", "surface.nromal", "gain: 1.0"), @"");
    assert_snapshot!(message_of("vec4f(surface", "vec4f(srface", "gain: 1.0"), @"");
    assert_snapshot!(message_of("1.0);", "1.0)", "gain: 1.0"), @"");
}

#[test]
fn another_signature() {
    assert_snapshot!(message_of("(surface: Surface, params: Params)", "(params: Params, surface: Surface)", "gain: 1.0"), @"");
    assert_snapshot!(message_of("fn effect", "fn efect", "gain: 1.0"), @"");
}

#[test]
fn no_params() {
    assert_snapshot!(message_of("struct Params {\n    /// Contrast, [0, 4].\n    gain: f32,\n}", "", "gain: 1.0"), @"");
}

#[test]
fn an_import_of_nothing() {
    assert_snapshot!(message_of("common::surface::Surface", "common::surfaces::Surface", "gain: 1.0"), @"");
}

#[test]
fn parameters() {
    assert_snapshot!(message_of("gain", "gain", "gian: 1.0"), @"");
    assert_snapshot!(message_of("gain", "gain", "gain: 5"), @"");
}
