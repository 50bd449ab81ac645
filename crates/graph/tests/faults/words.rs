//! Words of the file's head, and what replaces them.

use insta::assert_snapshot;
use voxlume_graph::{Request, Value};

use crate::common::{message, message_for, request};

#[test]
fn format() {
    assert_snapshot!(message(&[(r#""six_face""#, r#""sixface""#)]), @"");
    assert_snapshot!(message_for(&[], &Request { format: Some("cubes".into()), ..request() }), @"");
}

#[test]
fn encoding() {
    assert_snapshot!(message(&[(r#""rgba16float""#, r#""rgba16""#)]), @"");
    assert_snapshot!(message_for(&[], &Request { encoding: Some("RGBA16Float".into()), ..request() }), @"");
}

#[test]
fn resolution() {
    assert_snapshot!(message(&[(r#"resolution: 64"#, r#"resolution: 100"#)]), @"");
    assert_snapshot!(message_for(&[], &Request { resolution: Some(1024), ..request() }), @"");
    assert_snapshot!(message(&[(r#"resolution: 64"#, r#"resolution: -1"#)]), @"");
}

#[test]
fn separability() {
    assert_snapshot!(message(&[(r#""conservative""#, r#""thick""#)]), @"");
}

/// A volume or buffer is no image.
#[test]
fn output() {
    assert_snapshot!(message(&[(r#"output: "final""#, r#"output: "difuse""#)]), @"");
    assert_snapshot!(message_for(&[], &Request { output: Some("shadow".into()), ..request() }), @"");
}

#[test]
fn output_of_no_image() {
    assert_snapshot!(message_for(&[], &Request { output: Some("volume".into()), ..request() }), @"");
}

#[test]
fn missing_field() {
    assert_snapshot!(message(&[(r#"    encoding: "rgba16float",
"#, r#""#)]), @"");
}

#[test]
fn unknown_field() {
    assert_snapshot!(message(&[(r#"output:"#, r#"outptu: 1, output:"#)]), @"");
}

#[test]
fn picture_size() {
    assert_snapshot!(message_for(&[], &Request::image(0, 48)), @"");
    assert_snapshot!(message_for(&[], &Request::image(64, 100_000)), @"");
}

#[test]
fn set() {
    assert_snapshot!(message_for(&[], &Request { set: vec![("difuse".into(), "step".into(), Value::Number(1.0))], ..request() }), @"");
    assert_snapshot!(message_for(&[], &Request { set: vec![("diffuse".into(), "stp".into(), Value::Number(1.0))], ..request() }), @"");
    assert_snapshot!(message_for(&[], &Request { set: vec![("diffuse".into(), "step".into(), Value::Number(7.0))], ..request() }), @"");
}
