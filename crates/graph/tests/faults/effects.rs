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
        (
            "\"surface\", \"volume\"],\n            writes: [\"diffuse\"]",
            "\"surface\"],\n            writes: [\"diffuse\"]",
        ),
        ("stepper: \"spheres\", step: 0.5, start: 1.0, ring: 5", params),
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
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"mine/thickness.wgsl"#)]), @r#"
    error: cannot read `mine/thickness.wgsl`: no such file
       ┌─ p.ron:28:18
       │
    28 │             run: "mine/thickness.wgsl",
       │                  ^^^^^^^^^^^^^^^^^^^^^
    "#);
}

#[test]
fn outside_the_folder() {
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"../diffuse.wgsl"#)]), @r#"
    error: an effect's file outside the pipeline's folder
       ┌─ p.ron:28:18
       │
    28 │             run: "../diffuse.wgsl",
       │                  ^^^^^^^^^^^^^^^^^ a path below the pipeline's folder
    "#);
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"/etc/diffuse.wgsl"#)]), @r#"
    error: an effect's file outside the pipeline's folder
       ┌─ p.ron:28:18
       │
    28 │             run: "/etc/diffuse.wgsl",
       │                  ^^^^^^^^^^^^^^^^^^^ a path below the pipeline's folder
    "#);
}

#[test]
fn a_typo() {
    assert_snapshot!(message_of("surface.normal", "surface.nromal", "gain: 1.0"), @r#"
    error: invalid field accessor `nromal`
      ┌─ FOLDER/mine.wgsl:9:26
      │
    9 │     return vec4f(surface.nromal * params.gain, 1.0);
      │                          ^^^^^^ invalid accessor
    "#);
    assert_snapshot!(message_of("vec4f(surface", "vec4f(srface", "gain: 1.0"), @r#"
    error: no definition in scope for identifier: `srface`
      ┌─ FOLDER/mine.wgsl:9:18
      │
    9 │     return vec4f(srface.normal * params.gain, 1.0);
      │                  ^^^^^^ unknown identifier
      │
      = did you mean `surface`?
    "#);
    assert_snapshot!(message_of("1.0);", "1.0)", "gain: 1.0"), @r#"
    error: expected `;`, found "}"
       ┌─ FOLDER/mine.wgsl:10:1
       │
    10 │ }
       │ ^ expected `;`
    "#);
}

#[test]
fn another_signature() {
    assert_snapshot!(message_of("(surface: Surface, params: Params)", "(params: Params, surface: Surface)", "gain: 1.0"), @r#"
    error: effect `mine` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ FOLDER/mine.wgsl:8:4
      │
    8 │ fn effect(params: Params, surface: Surface) -> vec4f {
      │    ^^^^^^ is `fn effect(params: Params, surface: Surface) -> vec4f`
    "#);
    assert_snapshot!(message_of("fn effect", "fn efect", "gain: 1.0"), @r#"
    error: effect `mine` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ FOLDER/mine.wgsl:8:4
      │
    8 │ fn efect(surface: Surface, params: Params) -> vec4f {
      │    ^^^^^ did you mean this?
    "#);
}

#[test]
fn no_params() {
    assert_snapshot!(message_of("struct Params {\n    /// Contrast, [0, 4].\n    gain: f32,\n}", "", "gain: 1.0"), @r#"
    error: no definition in scope for identifier: `Params`
      ┌─ FOLDER/mine.wgsl:5:37
      │
    5 │ fn effect(surface: Surface, params: Params) -> vec4f {
      │                                     ^^^^^^ unknown identifier
      │
      = add `import package::effect::ambient_occlusion::Params;`
    "#);
}

#[test]
fn an_import_of_nothing() {
    assert_snapshot!(message_of("common::surface::Surface", "common::surfaces::Surface", "gain: 1.0"), @r#"
    error: unknown module `package::common::surfaces`
      ┌─ FOLDER/mine.wgsl:1:8
      │
    1 │ import package::common::surfaces::Surface;
      │        ^^^^^^^^^^^^^^^^^^^^^^^^^ did you mean `package::common::surface`?
    "#);
}

#[test]
fn parameters() {
    assert_snapshot!(message_of("gain", "gain", "gian: 1.0"), @r#"
    error: pass `mine` lacks the parameter `gain`
       ┌─ FOLDER/p.ron:28:18
       │
    28 │             run: "mine.wgsl",
       │                  ^^^^^^^^^^^ a number in [0, 4]: Contrast.

    error: pass `mine` has no parameter `gian`
       ┌─ FOLDER/p.ron:31:22
       │
    31 │             params: (gian: 1.0),
       │                      ^^^^ did you mean `gain`? one of: gain
    "#);
    assert_snapshot!(message_of("gain", "gain", "gain: 5"), @r#"
    error: parameter `gain` of pass `mine` can't be 5
       ┌─ FOLDER/p.ron:31:28
       │
    31 │             params: (gain: 5),
       │                            ^ a number in [0, 4]: Contrast.
    "#);
}
