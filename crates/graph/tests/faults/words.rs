//! Words of the file's head, and what replaces them.

use insta::assert_snapshot;
use voxlume_graph::{Request, Value};

use crate::common::{message, message_for, request};

#[test]
fn format() {
    assert_snapshot!(message(&[(r#""six_face""#, r#""sixface""#)]), @r#"
    error: unknown storage format `sixface`
      ┌─ p.ron:2:13
      │
    2 │     format: "sixface",
      │             ^^^^^^^^^ did you mean `six_face`? one of: isotropic, six_face, sh2
    "#);
    assert_snapshot!(message_for(&[], &Request { format: Some("cubes".into()), ..request() }), @r#"
    error: unknown storage format `cubes`
     = one of: isotropic, six_face, sh2
    "#);
}

#[test]
fn tracer() {
    assert_snapshot!(message(&[(r#"tracer: "cones""#, r#"tracer: "cone""#)]), @r#"
    error: unknown tracer `cone`
       ┌─ p.ron:47:13
       │
    47 │     tracer: "cone",
       │             ^^^^^^ did you mean `cones`? one of: rays, cones
    "#);
    assert_snapshot!(message(&[(r#"run: "effect/diffuse""#, r#"run: "effect/diffuse", tracer: "sonar""#)]), @r#"
    error: unknown tracer `sonar`
       ┌─ p.ron:28:44
       │
    28 │             run: "effect/diffuse", tracer: "sonar",
       │                                            ^^^^^^^ one of: rays, cones
    "#);
    assert_snapshot!(message_for(&[], &Request { tracer: Some("sonar".into()), ..request() }), @r#"
    error: unknown tracer `sonar`
     = one of: rays, cones
    "#);
    assert_snapshot!(message(&[(r#"(run: "filter""#, r#"(run: "filter", tracer: "cones""#)]), @r#"
    error: pass `filter` traces nothing
       ┌─ p.ron:19:33
       │
    19 │         (run: "filter", tracer: "cones", reads: ["voxels", "radiance"], writes: ["volume"]),
       │                                 ^^^^^^^ a tracer named in vain
    "#);
}

#[test]
fn encoding() {
    assert_snapshot!(message(&[(r#""rgba16float""#, r#""rgba16""#)]), @r#"
    error: unknown encoding `rgba16`
      ┌─ p.ron:3:15
      │
    3 │     encoding: "rgba16",
      │               ^^^^^^^^ did you mean `rgba8`? one of: rgba8, rgba16float, rgba32float
    "#);
    assert_snapshot!(message_for(&[], &Request { encoding: Some("RGBA16Float".into()), ..request() }), @r#"
    error: unknown encoding `RGBA16Float`
     = did you mean `rgba16float`? one of: rgba8, rgba16float, rgba32float
    "#);
}

#[test]
fn format_options() {
    assert_snapshot!(message(&[(r#""six_face""#, r#""sh2:mop=projected:negatives=keep""#)]), @r#"
    error: unknown option of `sh2`: `mop`
      ┌─ p.ron:2:18
      │
    2 │     format: "sh2:mop=projected:negatives=keep",
      │                  ^^^ did you mean `mip`? one of: base, mip, negatives

    error: unknown `negatives` of `sh2`
      ┌─ p.ron:2:42
      │
    2 │     format: "sh2:mop=projected:negatives=keep",
      │                                          ^^^^ one of: clamp, window
      │
      = radiance below zero: cut off (clamp), or avoided by less of band 1 (window)
    "#);
    assert_snapshot!(message(&[(r#""six_face""#, r#""isotropic:base=lobe""#)]), @r#"
    error: unknown option of `isotropic`: `base`
      ┌─ p.ron:2:24
      │
    2 │     format: "isotropic:base=lobe",
      │                        ^^^^ it has none
    "#);
    assert_snapshot!(message_for(&[], &Request { format: Some("sh2:base".into()), ..request() }), @r#"
    error: unknown `base` of `sh2`
     = one of: isotropic, lobe
     = level 0: one value for all directions (isotropic), or the coefficients of a one-sided emitter (lobe)
    "#);
}

#[test]
fn encoding_options() {
    assert_snapshot!(message(&[(r#""rgba16float""#, r#""rgba8:range=-1""#)]), @r#"
    error: unknown `range` of `rgba8`
      ┌─ p.ron:3:28
      │
    3 │     encoding: "rgba8:range=-1",
      │                            ^^ a number in (0, 65504]: the largest premultiplied radiance or coefficient
    "#);
    assert_snapshot!(message(&[(r#""rgba16float""#, r#""rgba32float:range=2""#)]), @r#"
    error: unknown option of `rgba32float`: `range`
      ┌─ p.ron:3:28
      │
    3 │     encoding: "rgba32float:range=2",
      │                            ^^^^^ it has none
    "#);
    assert_snapshot!(message_for(&[], &Request { encoding: Some("rgba8:rang=2".into()), ..request() }), @r#"
    error: unknown option of `rgba8`: `rang`
     = did you mean `range`? one of: range
    "#);
    assert_eq!(message(&[(r#""rgba16float""#, r#""rgba8:range=2.5""#)]), "no fault");
}

#[test]
fn resolution() {
    assert_snapshot!(message(&[(r#"resolution: 64"#, r#"resolution: 1000"#)]), @r#"
    error: a grid of 1000 × 1000 × 1000 voxels
      ┌─ p.ron:4:17
      │
    4 │     resolution: 1000,
      │                 ^^^^ 8 to 512 along the longest side
    "#);
    assert_snapshot!(message_for(&[], &Request { resolution: Some(1024), ..request() }), @r#"
    error: a grid of 1024 × 1024 × 1024 voxels
     = 8 to 512 along the longest side
    "#);
    assert_snapshot!(message(&[(r#"resolution: 64"#, r#"resolution: -1"#)]), @r#"
    error: expected a whole number from 0 to 4294967295, found `-1`
      ┌─ p.ron:4:17
      │
    4 │     resolution: -1,
      │                 ^^
    "#);
}

#[test]
fn separability() {
    assert_snapshot!(message(&[(r#""conservative""#, r#""thick""#)]), @r#"
    error: unknown separability `thick`
      ┌─ p.ron:5:19
      │
    5 │     separability: "thick",
      │                   ^^^^^^^ one of: conservative, thin
    "#);
}

/// A volume or buffer is no image.
#[test]
fn output() {
    assert_snapshot!(message(&[(r#"output: "final""#, r#"output: "difuse""#)]), @r#"
    error: unknown output `difuse`
      ┌─ p.ron:6:13
      │
    6 │     output: "difuse",
      │             ^^^^^^^^ did you mean `diffuse`? one of: diffuse, specular, final, albedo, normal, geometry, depth, emission
    "#);
    assert_snapshot!(message_for(&[], &Request { output: Some("shadow".into()), ..request() }), @r#"
    error: unknown output `shadow`
     = one of: diffuse, specular, final, albedo, normal, geometry, depth, emission
    "#);
}

#[test]
fn output_of_no_image() {
    assert_snapshot!(message_for(&[], &Request { output: Some("volume".into()), ..request() }), @r#"
    error: unknown output `volume`
     = one of: diffuse, specular, final, albedo, normal, geometry, depth, emission
    "#);
}

#[test]
fn missing_field() {
    assert_snapshot!(message(&[(r#"    encoding: "rgba16float",
"#, r#""#)]), @r#"
    error: missing field `encoding`
      ┌─ p.ron:1:1
      │
    1 │ (
      │ ^ needed here
    "#);
}

#[test]
fn unknown_field() {
    assert_snapshot!(message(&[(r#"output:"#, r#"outptu: 1, output:"#)]), @r#"
    error: unknown field `outptu`
      ┌─ p.ron:6:5
      │
    6 │     outptu: 1, output: "final",
      │     ^^^^^^ did you mean `output`? one of: format, encoding, tracer, resolution, grid, separability, output, passes
    "#);
}

#[test]
fn picture_size() {
    assert_snapshot!(message_for(&[], &Request::image(0, 48)), @r#"
    error: an image of 0 × 48 pixels
     = each side: 1 to 8192
    "#);
    assert_snapshot!(message_for(&[], &Request::image(64, 100_000)), @r#"
    error: an image of 64 × 100000 pixels
     = each side: 1 to 8192
    "#);
}

#[test]
fn set() {
    assert_snapshot!(message_for(&[], &Request { set: vec![("difuse".into(), "step".into(), Value::Number(1.0))], ..request() }), @r#"
    error: no pass is called `difuse`
     = did you mean `diffuse`? one of: voxelize, shadow_maps, light, filter, bounce, gbuffer, diffuse, specular, composite
    "#);
    assert_snapshot!(message_for(&[], &Request { set: vec![("diffuse".into(), "stp".into(), Value::Number(1.0))], ..request() }), @"
    error: pass `diffuse` has no parameter `stp`
     = did you mean `step`? one of: stepper, step, start, ring, distance, lamps
    ");
    assert_snapshot!(message_for(&[], &Request { set: vec![("diffuse".into(), "step".into(), Value::Number(7.0))], ..request() }), @r#"
    error: parameter `step` of pass `diffuse` can't be 7
     = a number in (0, 1]: Step over cell size, of the tangent spheres; 1 unless given.
    "#);
}

/// Whatever of these is wrong is told with its place.
#[test]
fn grid_and_method() {
    for (grid, told) in [
        (r#"(fit: "round")"#, "unknown fit `round`"),
        (r#"(min: (0, 0, 0))"#, "the grid is neither fitted nor given"),
        (r#"(fit: "cubic", min: (0, 0, 0), max: (1, 1, 1))"#, "the grid is neither fitted nor given"),
        (r#"(min: (0, 0, 0), max: (1, 0, 1))"#, "the grid is empty"),
        (r#"(min: (0, 0), max: (1, 1, 1))"#, "`min` must be a point"),
        (r#"(min: (0, 0, 0), max: (1, 1e16, 1))"#, "`max` must be a point"),
    ] {
        let text = message(&[("resolution: 64,", &format!("resolution: 64, grid: {grid},"))]);
        assert!(text.contains(told) && text.contains("p.ron:4:"), "{grid}: {text}");
    }
    for (params, told) in [
        (r#"method: "fast""#, r#"parameter `method` of pass `voxelize` can't be "fast""#),
        (r#"cutoff: -1"#, "parameter `cutoff` of pass `voxelize` can't be -1"),
        (r#"coverage: 1"#, "parameter `coverage` of pass `voxelize` can't be 1"),
    ] {
        let writes = r#"(run: "voxelize", writes: ["voxels"]"#;
        let text = message(&[(writes, &format!("{writes}, params: ({params})"))]);
        assert!(text.contains(told), "{params}: {text}");
    }
}

#[test]
fn shows() {
    assert_snapshot!(message(&[(r#"writes: ["diffuse"]"#, r#"writes: ["diffuse"], shows: "lihgt""#)]), @r#"
    error: `shows` can't be `lihgt`
       ┌─ p.ron:30:41
       │
    30 │             writes: ["diffuse"], shows: "lihgt",
       │                                         ^^^^^^^ did you mean `light`? one of: share, light, normal, albedo
    "#);
    assert_snapshot!(message(&[(r#"writes: ["surface"]"#, r#"writes: ["surface"], shows: "normal""#)]), @r#"
    error: pass `gbuffer` makes no image that `shows` could describe
       ┌─ p.ron:26:54
       │
    26 │         (run: "gbuffer", writes: ["surface"], shows: "normal"),
       │                                                      ^^^^^^^^ only a pass that makes an image for the screen has it
    "#);
}

#[test]
fn reference() {
    assert_snapshot!(message(&[(r#"writes: ["diffuse"]"#, r#"writes: ["diffuse"], reference: "irradiance""#)]), @r#"
    error: `reference` can't be `irradiance`
       ┌─ p.ron:30:45
       │
    30 │             writes: ["diffuse"], reference: "irradiance",
       │                                             ^^^^^^^^^^^^ one of: soft_shadow, ambient_occlusion, diffuse, specular, final
    "#);
}
