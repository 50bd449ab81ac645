//! Parameters of passes.

use insta::assert_snapshot;

use crate::common::message;

#[test]
fn missing() {
    assert_snapshot!(message(&[("bias: 1.5, ", "")]), @r#"
    error: pass `light` lacks the parameter `bias`
       ┌─ p.ron:11:18
       │
    11 │             run: "light",
       │                  ^^^^^^^ a number: How far over a voxel's centre a shadow map is asked; 1.5 is over every cell of a plane through it.
    "#);
    // What a tracer lets a pass choose has a default.
    assert_eq!(message(&[("stepper: \"spheres\", step: 0.5, ", "")]), "no fault");
    assert_snapshot!(message(&[(r#"occlusion: "shadow_map", "#, r#""#)]), @r#"
    error: pass `light` lacks the parameter `occlusion`
       ┌─ p.ron:11:18
       │
    11 │             run: "light",
       │                  ^^^^^^^ one of: shadow_map, voxel_ray
    "#);
    assert_snapshot!(message(&[(r#"(size: 512)"#, r#"()"#)]), @r#"
    error: pass `shadow_maps` lacks the parameter `size`
      ┌─ p.ron:9:15
      │
    9 │         (run: "shadow_maps", writes: ["shadow_maps"], params: ()),
      │               ^^^^^^^^^^^^^ a whole number from 16 to 4096
    "#);
    assert_snapshot!(message(&[(r#", params: (size: 512)"#, r#""#)]), @r#"
    error: pass `shadow_maps` lacks the parameter `size`
      ┌─ p.ron:9:15
      │
    9 │         (run: "shadow_maps", writes: ["shadow_maps"]),
      │               ^^^^^^^^^^^^^ a whole number from 16 to 4096
    "#);
}

#[test]
fn unknown() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 0.5, strat: 2"#)]), @r#"
    error: pass `diffuse` has no parameter `strat`
       ┌─ p.ron:31:53
       │
    31 │             params: (stepper: "spheres", step: 0.5, strat: 2, start: 1.0, ring: 5),
       │                                                     ^^^^^ did you mean `start`? one of: stepper, step, start, ring, distance, lamps
    "#);
    assert_snapshot!(message(&[(r#"(run: "voxelize", writes: ["voxels"])"#, r#"(run: "voxelize", writes: ["voxels"], params: (size: 3))"#)]), @r#"
    error: pass `voxelize` has no parameter `size`
      ┌─ p.ron:8:56
      │
    8 │         (run: "voxelize", writes: ["voxels"], params: (size: 3)),
      │                                                        ^^^^ one of: coverage, conflict, min, max, resolution, method, cutoff, walk
    "#);
}

#[test]
fn twice() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 0.5, step: 0.25"#)]), @r#"
    error: parameter `step` given twice
       ┌─ p.ron:31:53
       │
    31 │             params: (stepper: "spheres", step: 0.5, step: 0.25, start: 1.0, ring: 5),
       │                                                     ^^^^ the second
    "#);
}

#[test]
fn mistyped() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: "half""#)]), @r#"
    error: parameter `step` of pass `diffuse` can't be "half"
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: "half", start: 1.0, ring: 5),
       │                                                ^^^^^^ a number in (0, 1]: Step over cell size, of the tangent spheres; 1 unless given.
    "#);
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: (1, 2)"#)]), @r#"
    error: parameter `step` of pass `diffuse` can't be (1, 2)
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: (1, 2), start: 1.0, ring: 5),
       │                                                ^^^^^^ a number in (0, 1]: Step over cell size, of the tangent spheres; 1 unless given.
    "#);
    assert_snapshot!(message(&[(r#"occlusion: "shadow_map""#, r#"occlusion: 3"#)]), @r#"
    error: parameter `occlusion` of pass `light` can't be 3
       ┌─ p.ron:15:28
       │
    15 │                 occlusion: 3, emission: "area_lights",
       │                            ^ one of: shadow_map, voxel_ray
    "#);
    assert_snapshot!(message(&[(r#"size: 512"#, r#"size: "large""#)]), @r#"
    error: parameter `size` of pass `shadow_maps` can't be "large"
      ┌─ p.ron:9:70
      │
    9 │         (run: "shadow_maps", writes: ["shadow_maps"], params: (size: "large")),
      │                                                                      ^^^^^^^ a whole number from 16 to 4096
    "#);
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: Half"#)]), @r#"
    error: expected a number, found `Half`
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: Half, start: 1.0, ring: 5),
       │                                                ^^^^
    "#);
}

#[test]
fn out_of_range() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 1.5"#)]), @r#"
    error: parameter `step` of pass `diffuse` can't be 1.5
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: 1.5, start: 1.0, ring: 5),
       │                                                ^^^ a number in (0, 1]: Step over cell size, of the tangent spheres; 1 unless given.
    "#);
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 0"#)]), @r#"
    error: parameter `step` of pass `diffuse` can't be 0
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: 0, start: 1.0, ring: 5),
       │                                                ^ a number in (0, 1]: Step over cell size, of the tangent spheres; 1 unless given.
    "#);
    assert_snapshot!(message(&[(r#"bounces: 1"#, r#"bounces: 99"#)]), @r#"
    error: parameter `bounces` of pass `bounce` can't be 99
       ┌─ p.ron:24:31
       │
    24 │             params: (bounces: 99, stepper: "doubling", step: 1.0, start: 1.0),
       │                               ^^ a whole number from 0 to 16
    "#);
    assert_snapshot!(message(&[(r#"bounces: 1"#, r#"bounces: 0.5"#)]), @r#"
    error: parameter `bounces` of pass `bounce` can't be 0.5
       ┌─ p.ron:24:31
       │
    24 │             params: (bounces: 0.5, stepper: "doubling", step: 1.0, start: 1.0),
       │                               ^^^ a whole number from 0 to 16
    "#);
    assert_snapshot!(message(&[(r#"size: 512"#, r#"size: 8"#)]), @r#"
    error: parameter `size` of pass `shadow_maps` can't be 8
      ┌─ p.ron:9:70
      │
    9 │         (run: "shadow_maps", writes: ["shadow_maps"], params: (size: 8)),
      │                                                                      ^ a whole number from 16 to 4096
    "#);
}

#[test]
fn not_finite() {
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: NaN"#)]), @r#"
    error: expected a finite number, found `NaN`
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: NaN, start: 1.0, ring: 5),
       │                                                ^^^
    "#);
    assert_snapshot!(message(&[(r#"step: 0.5"#, r#"step: 1e999"#)]), @r#"
    error: expected a finite number, found `1e999`
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: 1e999, start: 1.0, ring: 5),
       │                                                ^^^^^
    "#);
}

#[test]
fn unknown_word() {
    assert_snapshot!(message(&[(r#""spheres""#, r#""sphere""#)]), @r#"
    error: parameter `stepper` of pass `diffuse` can't be "sphere"
       ┌─ p.ron:31:31
       │
    31 │             params: (stepper: "sphere", step: 0.5, start: 1.0, ring: 5),
       │                               ^^^^^^^^ one of: spheres, doubling
    "#);
    assert_snapshot!(message(&[(r#""shadow_map", emission"#, r#""shadow_maps", emission"#)]), @r#"
    error: parameter `occlusion` of pass `light` can't be "shadow_maps"
       ┌─ p.ron:15:28
       │
    15 │                 occlusion: "shadow_maps", emission: "area_lights",
       │                            ^^^^^^^^^^^^^ one of: shadow_map, voxel_ray
    "#);
    assert_snapshot!(message(&[(r#""spheres""#, r#"2"#)]), @r#"
    error: parameter `stepper` of pass `diffuse` can't be 2
       ┌─ p.ron:31:31
       │
    31 │             params: (stepper: 2, step: 0.5, start: 1.0, ring: 5),
       │                               ^ one of: spheres, doubling
    "#);
}
