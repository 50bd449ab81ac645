//! Passes and what they read, write and update.

use insta::assert_snapshot;

use crate::common::message;

#[test]
fn unknown_pass() {
    assert_snapshot!(message(&[(r#"run: "filter""#, r#"run: "fliter""#)]), @"");
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"effect/difuse"#)]), @"");
}

#[test]
fn unknown_condition() {
    assert_snapshot!(message(&[(r#"when: "glossy""#, r#"when: "shiny""#)]), @"");
}

#[test]
fn unknown_layers() {
    assert_snapshot!(message(&[(r#"when: "glossy""#, r#"layers: "light""#)]), @"");
}

#[test]
fn nobody_writes_what_is_read() {
    assert_snapshot!(message(&[(r#"reads: ["surface", "diffuse""#, r#"reads: ["surface", "difuse""#)]), @"");
    assert_snapshot!(message(&[(r#"(run: "gbuffer", writes: ["surface"]),"#, r#""#)]), @"");
}

#[test]
fn two_writers() {
    assert_snapshot!(message(&[(r#"writes: ["specular"]"#, r#"writes: ["diffuse"]"#), (r#""diffuse", "specular"]"#, r#""diffuse"]"#)]), @"");
}

#[test]
fn two_passes_of_one_name() {
    assert_snapshot!(message(&[(r#"run: "effect/specular","#, r#"run: "effect/specular", name: "diffuse","#)]), @"");
}

#[test]
fn cycle() {
    assert_snapshot!(message(&[(r#"(run: "gbuffer""#, r#"(name: "one", run: "effect/diffuse", reads: ["surface", "volume", "b"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0)),
        (name: "two", run: "effect/diffuse", reads: ["surface", "volume", "a"], writes: ["b"], params: (stepper: "spheres", step: 0.5, start: 1.0)),
        (run: "gbuffer""#)]), @"");
    assert_snapshot!(message(&[(r#"(run: "gbuffer""#, r#"(name: "one", run: "effect/diffuse", reads: ["surface", "volume", "b"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0)),
        (name: "two", run: "effect/diffuse", reads: ["surface", "volume", "c"], writes: ["b"], params: (stepper: "spheres", step: 0.5, start: 1.0)),
        (name: "three", run: "effect/diffuse", reads: ["surface", "volume", "a"], writes: ["c"], params: (stepper: "spheres", step: 0.5, start: 1.0)),
        (run: "gbuffer""#)]), @"");
}

#[test]
fn a_pass_that_waits_for_itself() {
    assert_snapshot!(message(&[(r#"(run: "gbuffer""#, r#"(name: "one", run: "effect/diffuse", reads: ["surface", "volume", "a"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0)),
        (run: "gbuffer""#)]), @"");
}

/// What a kind needs must be named, and what it knows nothing of must not.
#[test]
fn a_kinds_own_resources() {
    assert_snapshot!(message(&[(r#"reads: ["voxels", "radiance"], writes: ["volume"]"#, r#"reads: ["voxels"], writes: ["volume"]"#)]), @"");
    assert_snapshot!(message(&[(r#"run: "filter", reads: ["voxels", "radiance"]"#, r#"run: "filter", reads: ["voxels", "radiance", "shadow_maps"]"#)]), @"");
    assert_snapshot!(message(&[(r#"run: "voxelize", writes: ["voxels"]"#, r#"run: "voxelize""#)]), @"");
}

#[test]
fn a_read_that_a_shader_needs() {
    assert_snapshot!(message(&[(r#"reads: ["surface", "volume"],
            writes: ["diffuse"]"#, r#"reads: ["surface"],
            writes: ["diffuse"]"#)]), @"");
}

#[test]
fn a_read_in_vain() {
    assert_snapshot!(message(&[(r#"reads: ["surface", "volume"],
            writes: ["specular"]"#, r#"reads: ["surface", "volume", "diffuse"],
            writes: ["specular"]"#)]), @"");
}

#[test]
fn an_effect_that_writes_nothing_or_two_images() {
    assert_snapshot!(message(&[(r#"writes: ["specular"],"#, r#""#), (r#""diffuse", "specular"]"#, r#""diffuse"]"#), (r#"when: "glossy","#, r#""#), (r#"output: "final""#, r#"output: "diffuse""#)]), @"");
    assert_snapshot!(message(&[(r#"writes: ["specular"]"#, r#"writes: ["specular", "more"]"#)]), @"");
}

/// All that can be told at once is told at once.
#[test]
fn several_faults_at_once() {
    assert_snapshot!(message(&[(r#""six_face""#, r#""sixface""#), (r#"resolution: 64"#, r#"resolution: 63"#), (r#"run: "filter""#, r#"run: "fliter""#), (r#"reads: ["surface", "diffuse""#, r#"reads: ["surface", "difuse""#)]), @"");
}

#[test]
fn several_faults_of_parameters_at_once() {
    assert_snapshot!(message(&[(r#"bias: 1.5"#, r#"bais: 1.5"#), (r#"step: 0.5"#, r#"step: 5"#), (r#"bounces: 1"#, r#"bounces: 99"#)]), @"");
}
