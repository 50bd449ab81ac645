//! `voxlume check`.

use crate::folder::{Folder, PIPELINE, TINT};

#[test]
fn all_is_well() {
    let folder = Folder::new();
    let ran = folder.run("check .");
    assert_eq!(
        (ran.code, ran.stdout.as_str(), ran.stderr.as_str()),
        (Some(0), "1 pipeline, 1 scene, 1 WGSL module: no faults\n", "")
    );
    // What the program carries, without any file.
    std::fs::create_dir(folder.path().join("empty")).unwrap();
    assert_eq!(folder.run("check empty").stdout, "no faults\n");
    let ran = folder.run("check");
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    assert!(
        ran.stdout.starts_with("2 pipelines, ") && ran.stdout.ends_with(" WGSL modules: no faults\n"),
        "{}",
        ran.stdout
    );
}

#[test]
fn faults_of_all_files_at_once() {
    let folder = Folder::new();
    folder.edit("pipe.ron", PIPELINE, "resolution: 32", "resolution: 5");
    folder.file("box.ron", "(objects: [],, )");
    folder.edit("tint.wgsl", TINT, "vec4f(", "vec3f(");
    folder.refuses("check box.ron none.glb pipe.ron tint.wgsl out.txt", "error: expected identifier
  ┌─ box.ron:1:14
  │
1 │ (objects: [],, )
  │              ^

error: `out.txt` is nothing to check by its extension
 = one of: ron, gltf, glb, wgsl

error: invalid function `effect`
  ┌─ tint.wgsl:9:12
  │
9 │     return vec3f(surface.base_color * params.strength, 1.0);
  │            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ Composing expects 3 components but 4 were given

error: a grid of 5 × 5 × 5 voxels
  ┌─ pipe.ron:4:17
  │
4 │     resolution: 5,
  │                 ^ 8 to 512 along the longest side

error: cannot read `none.glb`: no such file

1 pipeline, 1 scene, 1 WGSL module: 5 faults");
}

#[test]
fn passes_that_nobody_reads_are_checked_too() {
    let folder = Folder::new();
    let unread = "passes: [\n(name: \"unread\", run: \"tint.wgsl\", reads: [\"surface\"], writes: [\"unread\"], params: (strength: 3.0)),";
    folder.edit("pipe.ron", PIPELINE, "passes: [", unread);
    folder.refuses("check pipe.ron", r#"error: parameter `strength` of pass `unread` can't be 3
  ┌─ pipe.ron:8:95
  │
8 │ (name: "unread", run: "tint.wgsl", reads: ["surface"], writes: ["unread"], params: (strength: 3.0)),
  │                                                                                               ^^^ a number in [0, 1]: How much of the colour remains.

1 pipeline: 1 fault"#);
}

#[test]
fn effects_of_one_name_in_two_folders() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path().join("b")).unwrap();
    folder.edit("tint.wgsl", TINT, "vec4f(", "vec3f(").edit("b/tint.wgsl", TINT, "fn effect", "fn efect");
    folder.refuses("check tint.wgsl b/tint.wgsl", "error: invalid function `effect`
  ┌─ tint.wgsl:9:12
  │
9 │     return vec3f(surface.base_color * params.strength, 1.0);
  │            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ Composing expects 3 components but 4 were given

error: effect `tint` must have `fn effect(surface: Surface, params: Params) -> vec4f`
  ┌─ b/tint.wgsl:8:4
  │
8 │ fn efect(surface: Surface, params: Params) -> vec4f {
  │    ^^^^^ did you mean this?

error: b/tint.wgsl declares no `effect`
  ┌─ wgsl/pass/effect.wgsl:5:34
  │
5 │ import package::effect::{Params, effect};
  │                                  ^^^^^^ did you mean `efect`? one of: Params, efect

2 WGSL modules: 3 faults");
}

#[test]
fn a_module_in_the_place_of_a_builtin_one() {
    let folder = Folder::new();
    std::fs::create_dir_all(folder.path().join("wgsl/common")).unwrap();
    folder.file("wgsl/common/constants.wgsl", "const PI: f32 = 3.0\n");
    folder.refuses(
        "check wgsl/common/constants.wgsl",
        "error: unfinished declaration
  ┌─ wgsl/common/constants.wgsl:1:17
  │
1 │ const PI: f32 = 3.0
  │                 ^^^ expected `;` after this

1 WGSL module: 1 fault",
    );
}
