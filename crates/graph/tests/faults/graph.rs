//! Passes and what they read, write and update.

use insta::assert_snapshot;

use crate::common::message;

#[test]
fn unknown_pass() {
    assert_snapshot!(message(&[(r#"run: "filter""#, r#"run: "fliter""#)]), @r#"
    error: unknown pass `fliter`
       ┌─ p.ron:19:15
       │
    19 │         (run: "fliter", reads: ["voxels", "radiance"], writes: ["volume"]),
       │               ^^^^^^^^ did you mean `filter`? one of: voxelize, shadow_maps, emission, light, filter, bounce, gbuffer, composite, voxel_view, effect/ambient_occlusion, effect/diffuse, effect/shadow, effect/soft_shadow, effect/specular
    "#);
    assert_snapshot!(message(&[(r#"effect/diffuse"#, r#"effect/difuse"#)]), @r#"
    error: unknown pass `effect/difuse`
       ┌─ p.ron:28:18
       │
    28 │             run: "effect/difuse",
       │                  ^^^^^^^^^^^^^^^ did you mean `effect/diffuse`? one of: voxelize, shadow_maps, emission, light, filter, bounce, gbuffer, composite, voxel_view, effect/ambient_occlusion, effect/diffuse, effect/shadow, effect/soft_shadow, effect/specular
    "#);
}

#[test]
fn unknown_condition() {
    assert_snapshot!(message(&[(r#"when: "glossy""#, r#"when: "shiny""#)]), @r#"
    error: unknown condition `shiny`
       ┌─ p.ron:37:19
       │
    37 │             when: "shiny",
       │                   ^^^^^^^ one of: lights, wide_lights, glossy, polished, shadow_mapped_lights, gathered_light
    "#);
    assert_snapshot!(message(&[(r#"when: "glossy""#, r#"full_size_when: "shiny""#)]), @r#"
    error: unknown condition `shiny`
       ┌─ p.ron:37:29
       │
    37 │             full_size_when: "shiny",
       │                             ^^^^^^^ one of: lights, wide_lights, glossy, polished, shadow_mapped_lights, gathered_light
    "#);
}

#[test]
fn unknown_layers() {
    assert_snapshot!(message(&[(r#"when: "glossy""#, r#"layers: "light""#)]), @r#"
    error: unknown layers `light`
       ┌─ p.ron:37:21
       │
    37 │             layers: "light",
       │                     ^^^^^^^ one of: lights (a layer for each four)
    "#);
}

#[test]
fn nobody_writes_what_is_read() {
    assert_snapshot!(message(&[(r#"reads: ["surface", "diffuse""#, r#"reads: ["surface", "difuse""#)]), @r#"
    error: pass `composite` must read `diffuse`
       ┌─ p.ron:41:18
       │
    41 │             run: "composite",
       │                  ^^^^^^^^^^^ gathered irradiance

    error: pass `composite` can't read `difuse`
       ┌─ p.ron:42:32
       │
    42 │             reads: ["surface", "difuse", "specular"],
       │                                ^^^^^^^^ did you mean `diffuse`? one of: surface, shadow, ao, diffuse, specular
    "#);
    assert_snapshot!(message(&[(r#"(run: "gbuffer", writes: ["surface"]),"#, r#""#)]), @r#"
    error: no pass writes `surface`
       ┌─ p.ron:29:21
       │
    29 │             reads: ["surface", "volume"],
       │                     ^^^^^^^^^ one of: diffuse, final, radiance, shadow_maps, specular, volume, voxels

    error: no pass writes `surface`
       ┌─ p.ron:35:21
       │
    35 │             reads: ["surface", "volume"],
       │                     ^^^^^^^^^ one of: diffuse, final, radiance, shadow_maps, specular, volume, voxels

    error: no pass writes `surface`
       ┌─ p.ron:42:21
       │
    42 │             reads: ["surface", "diffuse", "specular"],
       │                     ^^^^^^^^^ one of: diffuse, final, radiance, shadow_maps, specular, volume, voxels
    "#);
}

#[test]
fn two_writers() {
    assert_snapshot!(message(&[(r#"writes: ["specular"]"#, r#"writes: ["diffuse"]"#), (r#""diffuse", "specular"]"#, r#""diffuse"]"#)]), @r#"
    error: `diffuse` is written twice, by `diffuse` and `specular`
       ┌─ p.ron:36:22
       │
    36 │             writes: ["diffuse"],
       │                      ^^^^^^^^^ a second writer: `updates` changes what is there
    "#);
}

#[test]
fn two_passes_of_one_name() {
    assert_snapshot!(message(&[(r#"run: "effect/specular","#, r#"run: "effect/specular", name: "diffuse","#)]), @r#"
    error: two passes are called `diffuse`
       ┌─ p.ron:34:18
       │
    34 │             run: "effect/specular", name: "diffuse",
       │                  ^^^^^^^^^^^^^^^^^ the second; give it a `name`
    "#);
}

#[test]
fn cycle() {
    assert_snapshot!(message(&[(r#"(run: "gbuffer""#, r#"(name: "one", run: "effect/diffuse", reads: ["surface", "volume", "b"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
        (name: "two", run: "effect/diffuse", reads: ["surface", "volume", "a"], writes: ["b"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
        (run: "gbuffer""#)]), @r#"
    error: the passes form a cycle
       ┌─ p.ron:26:28
       │
    26 │         (name: "one", run: "effect/diffuse", reads: ["surface", "volume", "b"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
       │                            ^^^^^^^^^^^^^^^^ this pass waits for itself
       │
       = `one` needs `b` from `two`, `two` needs `a` from `one`
    "#);
    assert_snapshot!(message(&[(r#"(run: "gbuffer""#, r#"(name: "one", run: "effect/diffuse", reads: ["surface", "volume", "b"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
        (name: "two", run: "effect/diffuse", reads: ["surface", "volume", "c"], writes: ["b"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
        (name: "three", run: "effect/diffuse", reads: ["surface", "volume", "a"], writes: ["c"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
        (run: "gbuffer""#)]), @r#"
    error: the passes form a cycle
       ┌─ p.ron:26:28
       │
    26 │         (name: "one", run: "effect/diffuse", reads: ["surface", "volume", "b"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
       │                            ^^^^^^^^^^^^^^^^ this pass waits for itself
       │
       = `one` needs `b` from `two`, `two` needs `c` from `three`, `three` needs `a` from `one`
    "#);
}

#[test]
fn a_pass_that_waits_for_itself() {
    assert_snapshot!(message(&[(r#"(run: "gbuffer""#, r#"(name: "one", run: "effect/diffuse", reads: ["surface", "volume", "a"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
        (run: "gbuffer""#)]), @r#"
    error: the passes form a cycle
       ┌─ p.ron:26:28
       │
    26 │         (name: "one", run: "effect/diffuse", reads: ["surface", "volume", "a"], writes: ["a"], params: (stepper: "spheres", step: 0.5, start: 1.0, ring: 5)),
       │                            ^^^^^^^^^^^^^^^^ this pass waits for itself
       │
       = `one` needs `a` from `one`
    "#);
}

/// What a kind needs must be named, and what it knows nothing of must not.
#[test]
fn a_kinds_own_resources() {
    assert_snapshot!(message(&[(r#"reads: ["voxels", "radiance"], writes: ["volume"]"#, r#"reads: ["voxels"], writes: ["volume"]"#)]), @r#"
    error: pass `filter` must read `radiance`
       ┌─ p.ron:19:15
       │
    19 │         (run: "filter", reads: ["voxels"], writes: ["volume"]),
       │               ^^^^^^^^ each voxel's outgoing radiance
    "#);
    assert_snapshot!(message(&[(r#"run: "filter", reads: ["voxels", "radiance"]"#, r#"run: "filter", reads: ["voxels", "radiance", "shadow_maps"]"#)]), @r#"
    error: pass `filter` can't read `shadow_maps`
       ┌─ p.ron:19:55
       │
    19 │         (run: "filter", reads: ["voxels", "radiance", "shadow_maps"], writes: ["volume"]),
       │                                                       ^^^^^^^^^^^^^ one of: voxels, radiance
    "#);
    assert_snapshot!(message(&[(r#"run: "voxelize", writes: ["voxels"]"#, r#"run: "voxelize""#)]), @r#"
    error: pass `voxelize` must write `voxels`
      ┌─ p.ron:8:15
      │
    8 │         (run: "voxelize"),
      │               ^^^^^^^^^^ occupied voxels with reflectance, normal and emission

    error: no pass writes `voxels`
       ┌─ p.ron:12:21
       │
    12 │             reads: ["voxels", "shadow_maps"],
       │                     ^^^^^^^^ one of: diffuse, final, radiance, shadow_maps, specular, surface, volume

    error: no pass writes `voxels`
       ┌─ p.ron:19:33
       │
    19 │         (run: "filter", reads: ["voxels", "radiance"], writes: ["volume"]),
       │                                 ^^^^^^^^ one of: diffuse, final, radiance, shadow_maps, specular, surface, volume

    error: no pass writes `voxels`
       ┌─ p.ron:22:21
       │
    22 │             reads: ["voxels", "radiance"],
       │                     ^^^^^^^^ one of: diffuse, final, radiance, shadow_maps, specular, surface, volume
    "#);
}

#[test]
fn a_read_that_a_shader_needs() {
    assert_snapshot!(message(&[(r#"reads: ["surface", "volume"],
            writes: ["diffuse"]"#, r#"reads: ["surface"],
            writes: ["diffuse"]"#)]), @r#"
    error: pass `diffuse` uses `volume` without reading it
       ┌─ p.ron:28:18
       │
    28 │             run: "effect/diffuse",
       │                  ^^^^^^^^^^^^^^^^ its shader's variable `base` needs `volume` in `reads`
    "#);
}

#[test]
fn a_read_in_vain() {
    assert_snapshot!(message(&[(r#"reads: ["surface", "volume"],
            writes: ["specular"]"#, r#"reads: ["surface", "volume", "diffuse"],
            writes: ["specular"]"#)]), @r#"
    error: pass `specular` never uses `diffuse`
       ┌─ p.ron:35:42
       │
    35 │             reads: ["surface", "volume", "diffuse"],
       │                                          ^^^^^^^^^ read in vain
    "#);
}

#[test]
fn an_effect_that_writes_nothing_or_two_images() {
    assert_snapshot!(message(&[(r#"writes: ["specular"],"#, r#""#), (r#""diffuse", "specular"]"#, r#""diffuse"]"#), (r#"when: "glossy","#, r#""#), (r#"output: "final""#, r#"output: "diffuse""#)]), @r#"
    error: pass `specular` must write one image
       ┌─ p.ron:34:18
       │
    34 │             run: "effect/specular",
       │                  ^^^^^^^^^^^^^^^^^ `writes: ["name"]`
    "#);
    assert_snapshot!(message(&[(r#"writes: ["specular"]"#, r#"writes: ["specular", "more"]"#)]), @r#"
    error: pass `specular` must write one image
       ┌─ p.ron:36:34
       │
    36 │             writes: ["specular", "more"],
       │                                  ^^^^^^ `writes: ["name"]`
    "#);
}

/// All that can be told at once is told at once.
#[test]
fn several_faults_at_once() {
    assert_snapshot!(message(&[(r#""six_face""#, r#""sixface""#), (r#"resolution: 64"#, r#"resolution: 7"#), (r#"run: "filter""#, r#"run: "fliter""#), (r#"reads: ["surface", "diffuse""#, r#"reads: ["surface", "difuse""#)]), @r#"
    error: unknown storage format `sixface`
      ┌─ p.ron:2:13
      │
    2 │     format: "sixface",
      │             ^^^^^^^^^ did you mean `six_face`? one of: isotropic, six_face, sh2

    error: a grid of 7 × 7 × 7 voxels
      ┌─ p.ron:4:17
      │
    4 │     resolution: 7,
      │                 ^ 8 to 512 along the longest side

    error: unknown pass `fliter`
       ┌─ p.ron:19:15
       │
    19 │         (run: "fliter", reads: ["voxels", "radiance"], writes: ["volume"]),
       │               ^^^^^^^^ did you mean `filter`? one of: voxelize, shadow_maps, emission, light, filter, bounce, gbuffer, composite, voxel_view, effect/ambient_occlusion, effect/diffuse, effect/shadow, effect/soft_shadow, effect/specular

    error: pass `composite` must read `diffuse`
       ┌─ p.ron:41:18
       │
    41 │             run: "composite",
       │                  ^^^^^^^^^^^ gathered irradiance

    error: pass `composite` can't read `difuse`
       ┌─ p.ron:42:32
       │
    42 │             reads: ["surface", "difuse", "specular"],
       │                                ^^^^^^^^ did you mean `diffuse`? one of: surface, shadow, ao, diffuse, specular
    "#);
}

#[test]
fn several_faults_of_parameters_at_once() {
    assert_snapshot!(message(&[(r#"bias: 1.5"#, r#"bais: 1.5"#), (r#"step: 0.5"#, r#"step: 5"#), (r#"bounces: 1"#, r#"bounces: 99"#)]), @r#"
    error: pass `light` lacks the parameter `bias`
       ┌─ p.ron:11:18
       │
    11 │             run: "light",
       │                  ^^^^^^^ a number: How far over a voxel's centre a shadow map is asked; 1.5 is over every cell of a plane through it.

    error: pass `light` has no parameter `bais`
       ┌─ p.ron:16:17
       │
    16 │                 bais: 1.5, parts: 2,
       │                 ^^^^ did you mean `bias`? one of: occlusion, emission, bias, parts, lamps

    error: parameter `bounces` of pass `bounce` can't be 99
       ┌─ p.ron:24:31
       │
    24 │             params: (bounces: 99, stepper: "doubling", step: 1.0, start: 1.0),
       │                               ^^ a whole number from 0 to 16

    error: parameter `step` of pass `diffuse` can't be 5
       ┌─ p.ron:31:48
       │
    31 │             params: (stepper: "spheres", step: 5, start: 1.0, ring: 5),
       │                                                ^ a number in (0, 1]: Step over cell size, of the tangent spheres; 1 unless given.
    "#);
}
