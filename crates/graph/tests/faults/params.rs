//! Parameters of passes.

use insta::assert_snapshot;

use crate::common::message;

#[test]
fn missing() {
    assert_snapshot!(message(&[(r#"step: 0.5, "#, r#""#)]), @"");
    assert_snapshot!(message(&[(r#"occlusion: "shadow_map", "#, r#""#)]), @"");
    assert_snapshot!(message(&[(r#"(size: 512)"#, r#"()"#)]), @"");
    assert_snapshot!(message(&[(r#", params: (size: 512)"#, r#""#)]), @"");
}

#[test]
fn unknown() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 0.5, strat: 2"#)]), @"");
    assert_snapshot!(message(&[(r#"(run: "voxelize", writes: ["voxels"])"#, r#"(run: "voxelize", writes: ["voxels"], params: (size: 3))"#)]), @"");
}

#[test]
fn twice() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 0.5, step: 0.25"#)]), @"");
}

#[test]
fn mistyped() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: "half""#)]), @"");
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: (1, 2)"#)]), @"");
    assert_snapshot!(message(&[(r#"occlusion: "shadow_map""#, r#"occlusion: 3"#)]), @"");
    assert_snapshot!(message(&[(r#"size: 512"#, r#"size: "large""#)]), @"");
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: Half"#)]), @"");
}

#[test]
fn out_of_range() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 1.5"#)]), @"");
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 0"#)]), @"");
    assert_snapshot!(message(&[(r#"bounces: 1"#, r#"bounces: 99"#)]), @"");
    assert_snapshot!(message(&[(r#"bounces: 1"#, r#"bounces: 0.5"#)]), @"");
    assert_snapshot!(message(&[(r#"size: 512"#, r#"size: 8"#)]), @"");
}

#[test]
fn not_finite() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: NaN"#)]), @"");
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 1e999"#)]), @"");
}

#[test]
fn unknown_word() {
    assert_snapshot!(message(&[(r#""spheres""#, r#""sphere""#)]), @"");
    assert_snapshot!(message(&[(r#""shadow_map", emission"#, r#""shadow_maps", emission"#)]), @"");
    assert_snapshot!(message(&[(r#""spheres""#, r#"2"#)]), @"");
}
