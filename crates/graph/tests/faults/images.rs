//! Images: their size, texels and names, and their values of the last frame.

use insta::assert_snapshot;
use voxlume_graph::Pipeline;

use crate::common::{message, plan, request, rich, with};

/// The diffuse effect's entry with further words.
fn diffuse(words: &str) -> String {
    message(&[("writes: [\"diffuse\"],", &format!("writes: [\"diffuse\"], {words},"))])
}

const EFFECT: &str = "import package::common::surface::Surface;

struct Params {
    /// [0, 8]
    radius: u32,
}

var SOURCE;

fn effect(surface: Surface, params: Params) -> vec4f {
    return vec4f(textureLoad(source, surface.pixel, 0, 0)) * f32(params.radius);
}
";

/// The message when an effect between diffuse light and composite declares `source` like this, reads such names, and the
/// diffuse effect's entry has further words.
fn between(source: &str, reads: &str, words: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("soft.wgsl"), EFFECT.replace("SOURCE", source)).unwrap();
    let entry = format!(
        "(run: \"soft.wgsl\", reads: [\"surface\", {reads}], writes: [\"soft\"], params: (radius: 2)), (\n            run: \"composite\""
    );
    let text = with(&[
        ("(\n            run: \"composite\"", &entry),
        (
            "reads: [\"surface\", \"diffuse\", \"specular\"]",
            "reads: [\"surface\", \"soft as diffuse\", \"specular\"]",
        ),
        ("writes: [\"diffuse\"],", &format!("writes: [\"diffuse\"], {words}")),
    ]);
    let file = folder.path().join("p.ron");
    std::fs::write(&file, text).unwrap();
    match Pipeline::load(&file).and_then(|pipeline| plan(&pipeline, &rich(), &request())) {
        Ok(_) => "no fault".into(),
        // The folder's name is another every time.
        Err(faults) => faults.to_string().replace(folder.path().to_str().unwrap(), "FOLDER"),
    }
}

const FLOATS: &str = "source: texture_2d_array<f32>";

#[test]
fn an_effect_stands_between_another_and_the_composite() {
    assert_eq!(between(FLOATS, "\"diffuse as source\"", ""), "no fault");
    // Whatever its size and texels.
    assert_eq!(between(FLOATS, "\"diffuse as source\"", "size: \"1/3\", texel: \"r32float\","), "no fault");
    let whole = "source: texture_2d_array<u32>";
    assert_eq!(between(whole, "\"diffuse as source\"", "size: (7, 9), texel: \"r32uint\","), "no fault");
    // Its own value of the last frame, and another's.
    assert_eq!(between(FLOATS, "\"soft.last as source\"", ""), "no fault");
    assert_eq!(between(FLOATS, "\"diffuse.last as source\"", ""), "no fault");
}

#[test]
fn texels_that_the_shader_does_not_want() {
    assert_snapshot!(between(FLOATS, "\"diffuse as source\"", "texel: \"r32uint\","), @r#"
    error: pass `soft` can't have `diffuse` as `source`
       ┌─ FOLDER/p.ron:40:15
       │
    40 │         (run: "soft.wgsl", reads: ["surface", "diffuse as source"], writes: ["soft"], params: (radius: 2)), (
       │               ^^^^^^^^^^^ its texels are r32uint; the shader's variable wants a texture of floats
    "#);
    assert_snapshot!(between("source: texture_depth_2d_array", "\"diffuse as source\"", ""), @r#"
    error: pass `soft` can't have `diffuse` as `source`
       ┌─ FOLDER/p.ron:40:15
       │
    40 │         (run: "soft.wgsl", reads: ["surface", "diffuse as source"], writes: ["soft"], params: (radius: 2)), (
       │               ^^^^^^^^^^^ its texels are rgba16float; the shader's variable wants a texture of depths
    "#);
}

#[test]
fn images_without_a_name_in_the_composite() {
    let entry = "(run: \"effect/diffuse\", name: \"second\", reads: [\"surface\", \"volume\"], writes: [\"second\"], params: (stepper: \"spheres\", step: 0.5, start: 1.0, ring: 5)), (\n            run: \"composite\"";
    let reads = "reads: [\"surface\", \"diffuse\", \"specular\"]";
    let changes = [
        ("(\n            run: \"composite\"", entry),
        (reads, "reads: [\"surface\", \"second\", \"specular\"]"),
    ];
    assert_snapshot!(message(&changes), @r#"
    error: pass `composite` must read `diffuse`
       ┌─ p.ron:41:18
       │
    41 │             run: "composite",
       │                  ^^^^^^^^^^^ gathered irradiance

    error: pass `composite` can't read `second`
       ┌─ p.ron:42:32
       │
    42 │             reads: ["surface", "second", "specular"],
       │                                ^^^^^^^^ say as which image: `second as diffuse`; one of: surface, shadow, ao, diffuse, specular
    "#);
    // Run twice under two names, each with its own parameters.
    let named = [changes[0], (reads, "reads: [\"surface\", \"second as diffuse\", \"specular\"]")];
    assert_eq!(message(&named), "no fault");
}

#[test]
fn last_values() {
    assert_snapshot!(between(FLOATS, "\"diffuse\", \"nothing.last as source\"", ""), @r#"
    error: no pass writes `nothing.last`
       ┌─ FOLDER/p.ron:40:58
       │
    40 │         (run: "soft.wgsl", reads: ["surface", "diffuse", "nothing.last as source"], writes: ["soft"], params: (radius: 2)), (
       │                                                          ^^^^^^^^^^^^^^^^^^^^^^^^ one of: diffuse, final, radiance, shadow_maps, soft, specular, surface, volume, voxels
    "#);
    let reads = "reads: [\"voxels\", \"radiance\"],\n            updates";
    assert_snapshot!(message(&[(reads, "reads: [\"voxels\", \"radiance.last\"],\n            updates")]), @r#"
    error: `radiance` has no last value
       ┌─ p.ron:22:31
       │
    22 │             reads: ["voxels", "radiance.last"],
       │                               ^^^^^^^^^^^^^^^ only images have one; this is of the sort `radiance`
    "#);
}

#[test]
fn sizes() {
    assert_snapshot!(diffuse("scale: 3"), @r#"
    error: unknown `scale`
       ┌─ p.ron:30:41
       │
    30 │             writes: ["diffuse"], scale: 3,
       │                                         ^ one of: 1, 2, 4, 8; 2 gathers for every second pixel along x and y
       │
       = an image that is itself smaller than the screen has `size: "1/3"`
    "#);
    assert_snapshot!(diffuse("scale: 0.5"), @r#"
    error: unknown `scale`
       ┌─ p.ron:30:41
       │
    30 │             writes: ["diffuse"], scale: 0.5,
       │                                         ^^^ one of: 1, 2, 4, 8; 2 gathers for every second pixel along x and y
       │
       = an image that is itself smaller than the screen has `size: "1/3"`
    "#);
    assert_snapshot!(diffuse("size: \"1/65\""), @r#"
    error: `size` must be that of an image
       ┌─ p.ron:30:40
       │
    30 │             writes: ["diffuse"], size: "1/65",
       │                                        ^^^^^^ width and height, each from 1 to 8192; or a share of the screen's from "1/1" to "1/64"
    "#);
    assert_snapshot!(diffuse("size: (0, 4)"), @r#"
    error: `size` must be that of an image
       ┌─ p.ron:30:40
       │
    30 │             writes: ["diffuse"], size: (0, 4),
       │                                        ^ width and height, each from 1 to 8192; or a share of the screen's from "1/1" to "1/64"
    "#);
    assert_snapshot!(diffuse("size: (8193, 4)"), @r#"
    error: `size` must be that of an image
       ┌─ p.ron:30:40
       │
    30 │             writes: ["diffuse"], size: (8193, 4),
       │                                        ^ width and height, each from 1 to 8192; or a share of the screen's from "1/1" to "1/64"
    "#);
    assert_snapshot!(diffuse("scale: 2, size: (4, 4)"), @r#"
    error: pass `diffuse` has both `scale` and `size`
       ┌─ p.ron:30:41
       │
    30 │             writes: ["diffuse"], scale: 2, size: (4, 4),
       │                                         ^ `scale` brings an effect up to the screen's size; an image of another size is left as it is
    "#);
    assert_snapshot!(diffuse("texel: \"rgb8\""), @r#"
    error: unknown texel `rgb8`
       ┌─ p.ron:30:41
       │
    30 │             writes: ["diffuse"], texel: "rgb8",
       │                                         ^^^^^^ one of: rgba16float, rgba32float, rg32float, r32float, r32uint, rgba8unorm
    "#);
    assert_snapshot!(diffuse("interleave: true, texel: \"r32float\""), @r#"
    error: pass `diffuse` can't have `interleave` with r32float texels
       ┌─ p.ron:30:59
       │
    30 │             writes: ["diffuse"], interleave: true, texel: "r32float",
       │                                                           ^^^^^^^^^^ it takes means, of rgba16float alone
    "#);
}

#[test]
fn update_words() {
    assert_eq!(diffuse("update: on_demand"), "no fault");
    assert_eq!(diffuse("update: (every: 3)"), "no fault");
    assert_snapshot!(diffuse("update: (every: 0)"), @r#"
    error: unknown `update`
       ┌─ p.ron:30:42
       │
    30 │             writes: ["diffuse"], update: (every: 0),
       │                                          ^ `on_demand`, or `(every: N)` with N from 1 to 10000 frames
    "#);
    assert_snapshot!(diffuse("update: sometimes"), @r#"
    error: unknown `update`
       ┌─ p.ron:30:42
       │
    30 │             writes: ["diffuse"], update: sometimes,
       │                                          ^^^^^^^^^ `on_demand`, or `(every: N)` with N from 1 to 10000 frames
    "#);
}
