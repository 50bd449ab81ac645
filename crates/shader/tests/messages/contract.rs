//! Modules that do not declare what their kind must.

use insta::assert_snapshot;
use voxlume_fault::Faults;
use voxlume_shader::{Contract, EFFECT, FORMAT_SAMPLE, TRACER, link};

use crate::library;

fn fulfils(path: &str, text: &str) -> Result<(), Faults> {
    let surface = ("common/surface", "struct Surface { normal: vec3f }\n");
    let shader = link(&library(&[surface, (path, text)]), path, &[]).unwrap().check().unwrap();
    shader.fulfils(Contract::of(path).unwrap(), path)
}

#[test]
fn effects() {
    let good = "import package::common::surface::Surface;
struct Params { gain: f32 }
alias Color = vec4<f32>;
fn effect(s: Surface, p: Params) -> Color { return Color(p.gain); }
";
    fulfils("effect/glow", good).unwrap();
    let wrong = |from: &str, to: &str| {
        let text = good.replace(from, to);
        assert_ne!(text, good);
        fulfils("effect/glow", &text).unwrap_err()
    };
    assert_snapshot!(wrong("-> Color { return Color(p.gain); }", "-> vec3f { return vec3f(p.gain); }"), @r#"
    error: effect `glow` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ effect/glow.wgsl:4:4
      │
    4 │ fn effect(s: Surface, p: Params) -> vec3f { return vec3f(p.gain); }
      │    ^^^^^^ is `fn effect(s: Surface, p: Params) -> vec3f`
    "#);
    assert_snapshot!(wrong("s: Surface, ", ""), @r#"
    error: effect `glow` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ effect/glow.wgsl:4:4
      │
    4 │ fn effect(p: Params) -> Color { return Color(p.gain); }
      │    ^^^^^^ is `fn effect(p: Params) -> vec4f`
    "#);
    assert_snapshot!(wrong("-> Color { return Color(p.gain); }", "{}"), @r#"
    error: effect `glow` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ effect/glow.wgsl:4:4
      │
    4 │ fn effect(s: Surface, p: Params) {}
      │    ^^^^^^ is `fn effect(s: Surface, p: Params)`
    "#);
    assert_snapshot!(wrong("fn effect", "fn efect"), @r#"
    error: effect `glow` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ effect/glow.wgsl:4:4
      │
    4 │ fn efect(s: Surface, p: Params) -> Color { return Color(p.gain); }
      │    ^^^^^ did you mean this?
    "#);
    assert_snapshot!(fulfils("effect/glow", "const GAIN = 1.0;\n").unwrap_err(), @r#"
    error: effect `glow` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ effect/glow.wgsl:1:1
      │
    1 │ const GAIN = 1.0;
      │ ^ nowhere in this file
    "#);
    assert_snapshot!(fulfils("effect/glow", "const effect = 1.0;\n").unwrap_err(), @r#"
    error: effect `glow` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ effect/glow.wgsl:1:7
      │
    1 │ const effect = 1.0;
      │       ^^^^^^ is no plain function
    "#);
}

#[test]
fn formats() {
    let sample = "fn voxel_sample(a: vec3f, b: f32, c: vec3f) -> vec4f { return vec4f(a * c, b); }\n";
    fulfils("format/new/sample", sample).unwrap();
    let error = fulfils(
        "format/new/sample",
        &sample.replace("b: f32, c: vec3f", "b: vec3f, c: f32").replace("a * c, b", "a * b, c"),
    );
    assert_snapshot!(error.unwrap_err(), @r#"
    error: format `new` must have `fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f`
      ┌─ format/new/sample.wgsl:1:4
      │
    1 │ fn voxel_sample(a: vec3f, b: vec3f, c: f32) -> vec4f { return vec4f(a * b, c); }
      │    ^^^^^^^^^^^^ is `fn voxel_sample(a: vec3f, b: vec3f, c: f32) -> vec4f`
    "#);
}

#[test]
fn tracers() {
    let asked = "struct Apex { p: vec3f }\nstruct Lobe { s: u32 }\nstruct Reach { d: f32 }\nstruct Gathered { a: f32 }\n\
                 fn trace_gather(a: Apex, l: Lobe, r: Reach) -> Gathered { return Gathered(); }\n";
    let opacity = "fn trace_opacity(a: Apex, l: Lobe, r: Reach, f: f32) -> f32 { return f; }\n";
    fulfils("tracer/new/trace", &format!("{asked}{opacity}")).unwrap();
    assert_snapshot!(fulfils("tracer/new/trace", asked).unwrap_err(), @"
    error: tracer `new` must have `fn trace_opacity(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32) -> f32`
      ┌─ tracer/new/trace.wgsl:1:1
      │
    1 │ struct Apex { p: vec3f }
      │ ^ nowhere in this file
    ");
}

#[test]
fn contracts_go_by_path() {
    assert_eq!(Contract::of("effect/diffuse"), Some(&EFFECT));
    assert_eq!(Contract::of("format/sh2/sample"), Some(&FORMAT_SAMPLE));
    assert_eq!(Contract::of("tracer/cones/trace"), Some(&TRACER));
    assert_eq!(Contract::of("format/sh2/store"), None);
    assert_eq!(Contract::of("format/a/b/sample"), None);
    assert_eq!(Contract::of("pass/light"), None);
}
