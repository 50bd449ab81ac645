//! Pipelines, parameters and shaders that can't be used.

use crate::folder::{Folder, PIPELINE, TINT};

const RENDER: &str = "render box.ron --pipeline pipe.ron -o out.png";

#[test]
fn unknown_pipeline() {
    Folder::new().refuses(
        "render box.ron --pipeline ig -o out.png",
        "error: unknown pipeline `ig`
 = did you mean `gi`? one of: gi, rauwendaal
 = or a file, whose name ends in `.ron`",
    );
}

#[test]
fn missing_pipeline() {
    Folder::new().refuses(
        "render box.ron --pipeline none.ron -o out.png",
        "error: cannot read `none.ron`: no such file",
    );
}

#[test]
fn unknown_format() {
    Folder::new().refuses(
        "render box.ron --format sixface -o out.png",
        "loading box.ron
planning
error: unknown storage format `sixface`
 = did you mean `six_face`? one of: isotropic, six_face, sh2",
    );
}

#[test]
fn unknown_words_of_the_file_all_at_once() {
    let folder = Folder::new();
    folder.file(
        "pipe.ron",
        PIPELINE.replace("isotropic", "isotropi").replace("16float", "9").replace("32", "5"),
    );
    folder.refuses(
        RENDER,
        r#"loading box.ron
planning
error: unknown storage format `isotropi`
  ┌─ pipe.ron:2:13
  │
2 │     format: "isotropi",
  │             ^^^^^^^^^^ did you mean `isotropic`? one of: isotropic, six_face, sh2

error: unknown encoding `rgba9`
  ┌─ pipe.ron:3:15
  │
3 │     encoding: "rgba9",
  │               ^^^^^^^ did you mean `rgba8`? one of: rgba8, rgba16float, rgba32float

error: a grid of 5 × 5 × 5 voxels
  ┌─ pipe.ron:4:17
  │
4 │     resolution: 5,
  │                 ^ 8 to 512 along the longest side"#,
    );
}

#[test]
fn unknown_image() {
    Folder::new().refuses(
        "render box.ron --pipeline pipe.ron --output tin -o out.png",
        "loading box.ron
planning
error: unknown output `tin`
 = did you mean `tint`? one of: tint, albedo, normal, geometry, depth, emission",
    );
}

#[test]
fn cycle() {
    let folder = Folder::new();
    let other = "(name: \"other\", run: \"tint.wgsl\", reads: [\"surface\", \"tint\"], writes: [\"other\"], params: (strength: 1.0)),
        (run: \"tint.wgsl\", reads: [\"other\", \"surface\"]";
    folder.edit("pipe.ron", PIPELINE, "(run: \"tint.wgsl\", reads: [\"surface\"]", other);
    folder.refuses(RENDER, r#"loading box.ron
planning
error: the passes form a cycle
  ┌─ pipe.ron:9:30
  │
9 │         (name: "other", run: "tint.wgsl", reads: ["surface", "tint"], writes: ["other"], params: (strength: 1.0)),
  │                              ^^^^^^^^^^^ this pass waits for itself
  │
  = `other` needs `tint` from `tint`, `tint` needs `other` from `other`"#);
}

#[test]
fn missing_parameter() {
    let folder = Folder::new();
    folder.edit("pipe.ron", PIPELINE, ", params: (strength: 0.5)", "");
    folder.refuses(
        RENDER,
        r#"loading box.ron
planning
error: pass `tint` lacks the parameter `strength`
  ┌─ pipe.ron:9:15
  │
9 │         (run: "tint.wgsl", reads: ["surface"], writes: ["tint"]),
  │               ^^^^^^^^^^^ a number in [0, 1]: How much of the colour remains."#,
    );
}

#[test]
fn unknown_parameter_and_one_out_of_range() {
    let folder = Folder::new();
    folder.edit("pipe.ron", PIPELINE, "strength: 0.5", "strength: 1.5, stength: 0.5");
    folder.refuses(RENDER, r#"loading box.ron
planning
error: parameter `strength` of pass `tint` can't be 1.5
  ┌─ pipe.ron:9:85
  │
9 │         (run: "tint.wgsl", reads: ["surface"], writes: ["tint"], params: (strength: 1.5, stength: 0.5)),
  │                                                                                     ^^^ a number in [0, 1]: How much of the colour remains.

error: pass `tint` has no parameter `stength`
  ┌─ pipe.ron:9:90
  │
9 │         (run: "tint.wgsl", reads: ["surface"], writes: ["tint"], params: (strength: 1.5, stength: 0.5)),
  │                                                                                          ^^^^^^^ did you mean `strength`? one of: strength"#);
}

#[test]
fn settings_of_no_pass_and_no_parameter() {
    let folder = Folder::new();
    folder.refuses(
        &format!("{RENDER} --set tnit.strength=1"),
        "loading box.ron
planning
error: no pass is called `tnit`
 = did you mean `tint`? one of: gbuffer, tint",
    );
    folder.refuses(
        &format!("{RENDER} --set tint.strenth=1"),
        "loading box.ron
planning
error: pass `tint` has no parameter `strenth`
 = did you mean `strength`? one of: strength",
    );
}

#[test]
fn typo_in_an_effect() {
    let folder = Folder::new();
    folder.edit("pipe.ron", PIPELINE, ", params: (strength: 0.5)", "");
    folder.edit("tint.wgsl", TINT, "params.strength", "params.strenght");
    folder.refuses(
        RENDER,
        "loading box.ron
planning
error: invalid field accessor `strenght`
  ┌─ tint.wgsl:9:46
  │
9 │     return vec4f(surface.base_color * params.strenght, 1.0);
  │                                              ^^^^^^^^ invalid accessor",
    );
}

#[test]
fn effect_outside_the_folder() {
    let folder = Folder::new();
    folder.edit("pipe.ron", PIPELINE, "tint.wgsl", "../tint.wgsl");
    folder.refuses(
        RENDER,
        r#"loading box.ron
planning
error: an effect's file outside the pipeline's folder
  ┌─ pipe.ron:9:15
  │
9 │         (run: "../tint.wgsl", reads: ["surface"], writes: ["tint"], params: (strength: 0.5)),
  │               ^^^^^^^^^^^^^^ a path below the pipeline's folder"#,
    );
}

#[test]
fn too_many_voxels_and_pixels() {
    Folder::new().refuses(
        "render box.ron --resolution 100000 --size 99999x10 -o out.png",
        "loading box.ron
planning
error: a grid of 100000 × 100000 × 100000 voxels
 = 8 to 512 along the longest side

error: an image of 99999 × 10 pixels
 = each side: 1 to 8192",
    );
}
