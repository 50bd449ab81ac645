//! What can be wrong between modules.

use insta::assert_snapshot;
use voxlume_shader::{check_all, link};

use crate::{library, link_last, link_message};

const CONE: (&str, &str) = (
    "common/cone",
    "struct Cone { aperture: f32 }\nfn cone_sample(cone: Cone) -> f32 { return cone.aperture; }\n",
);

#[test]
fn unknown_module() {
    assert_snapshot!(link_message(&[CONE, ("pass/a", "// Light.\nimport package::common::cones::cone_sample;\n")]), @r#"
    error: unknown module `package::common::cones`
      ┌─ pass/a.wgsl:2:8
      │
    2 │ import package::common::cones::cone_sample;
      │        ^^^^^^^^^^^^^^^^^^^^^^ did you mean `package::common::cone`?
    "#);
    assert_snapshot!(link_message(&[CONE, ("pass/a", "import package::common::light::lit;")]), @r#"
    error: unknown module `package::common::light`
      ┌─ pass/a.wgsl:1:8
      │
    1 │ import package::common::light::lit;
      │        ^^^^^^^^^^^^^^^^^^^^^^ one of: package::common::cone
    "#);
    assert_snapshot!(link_message(&[CONE, ("pass/a", "import package::light::lit;")]), @r#"
    error: unknown module `package::light`
      ┌─ pass/a.wgsl:1:8
      │
    1 │ import package::light::lit;
      │        ^^^^^^^^^^^^^^ one of: package::common::cone, package::pass::a
    "#);
    assert_snapshot!(link_message(&[CONE, ("pass/a", "import package::common::cone;")]), @r#"
    error: unknown module `package::common`
      ┌─ pass/a.wgsl:1:8
      │
    1 │ import package::common::cone;
      │        ^^^^^^^^^^^^^^^ one of: package::common::cone, package::pass::a
      │
      = `package::common::cone` is a module: name what to import from it
    "#);
    assert_snapshot!(link(&library(&[CONE]), "common/conee", &[]).unwrap_err(), @r#"
    error: unknown module `common/conee`
     = did you mean `common/cone`? one of: common/cone
    "#);
}

#[test]
fn item_that_its_module_lacks() {
    assert_snapshot!(link_message(&[CONE, ("pass/a", "import package::common::cone::{Cone, cone_trace};\n")]), @r#"
    error: common/cone.wgsl declares no `cone_trace`
      ┌─ pass/a.wgsl:1:38
      │
    1 │ import package::common::cone::{Cone, cone_trace};
      │                                      ^^^^^^^^^^ one of: Cone, cone_sample
    "#);
    assert_snapshot!(link_message(&[CONE, ("pass/a", "import package::common::cone::{aperture};\n")]), @r#"
    error: common/cone.wgsl declares no `aperture`
      ┌─ pass/a.wgsl:1:32
      │
    1 │ import package::common::cone::{aperture};
      │                                ^^^^^^^^ one of: Cone, cone_sample
    "#);
}

#[test]
fn malformed_imports() {
    let text = "import common::cone::Cone;
import package::common::cone::Cone as C;
import package::common::cone::{Cone,, cone_sample};
import package;
import package::common::cone::{};
";
    assert_snapshot!(link_message(&[CONE, ("pass/a", text)]), @r#"
    error: malformed import
      ┌─ pass/a.wgsl:1:8
      │
    1 │ import common::cone::Cone;
      │        ^^^^^^ expected `package`
      │
      = write `import package::folder::module::name;`
      = or `import package::folder::module::{name, other};`

    error: malformed import
      ┌─ pass/a.wgsl:2:36
      │
    2 │ import package::common::cone::Cone as C;
      │                                    ^^ expected `::` or `;`
      │
      = write `import package::folder::module::name;`
      = or `import package::folder::module::{name, other};`

    error: malformed import
      ┌─ pass/a.wgsl:3:37
      │
    3 │ import package::common::cone::{Cone,, cone_sample};
      │                                     ^ expected a name or `}`
      │
      = write `import package::folder::module::name;`
      = or `import package::folder::module::{name, other};`

    error: malformed import
      ┌─ pass/a.wgsl:4:15
      │
    4 │ import package;
      │               ^ expected `::`
      │
      = write `import package::folder::module::name;`
      = or `import package::folder::module::{name, other};`

    error: malformed import
      ┌─ pass/a.wgsl:5:32
      │
    5 │ import package::common::cone::{};
      │                                ^ expected a name
      │
      = write `import package::folder::module::name;`
      = or `import package::folder::module::{name, other};`
    "#);
    assert_snapshot!(link_message(&[CONE, ("pass/a", "import package::common::cone::Cone")]), @r#"
    error: malformed import
      ┌─ pass/a.wgsl:1:35
      │
    1 │ import package::common::cone::Cone
      │                                   ^ expected `::` or `;`
      │
      = write `import package::folder::module::name;`
      = or `import package::folder::module::{name, other};`
    "#);
}

#[test]
fn imports_below_declarations() {
    assert_snapshot!(link_message(&[CONE, ("pass/a", "const A = 1;\nimport package::common::cone::Cone;\n")]), @r#"
    error: misplaced import
      ┌─ pass/a.wgsl:2:1
      │
    2 │ import package::common::cone::Cone;
      │ ^^^^^^ imports come before all declarations
    "#);
}

#[test]
fn one_name_in_two_modules() {
    let text = "import package::common::cone::cone_sample;\n\nstruct Cone { a: f32 }\n";
    assert_snapshot!(link_message(&[CONE, ("pass/a", text)]), @r#"
    error: `Cone` is declared twice
      ┌─ pass/a.wgsl:3:8
      │
    3 │ struct Cone { a: f32 }
      │        ^^^^ also declared at common/cone.wgsl:1:8
    "#);
}

#[test]
fn name_used_without_import() {
    let middle = (
        "common/trace",
        "import package::common::cone::{Cone, cone_sample};\nfn trace(cone: Cone) -> f32 { return cone_sample(cone); }\n",
    );
    let text = "import package::common::trace::trace;\nfn a() -> f32 { return trace(Cone(1.0)) + cone_sample(Cone(2.0)); }\n";
    assert_snapshot!(link_message(&[CONE, middle, ("pass/a", text)]), @r#"
    error: `Cone` is not imported
      ┌─ pass/a.wgsl:2:30
      │
    2 │ fn a() -> f32 { return trace(Cone(1.0)) + cone_sample(Cone(2.0)); }
      │                              ^^^^ declared in common/cone.wgsl, not imported here
      │
      = add `import package::common::cone::Cone;`

    error: `cone_sample` is not imported
      ┌─ pass/a.wgsl:2:43
      │
    2 │ fn a() -> f32 { return trace(Cone(1.0)) + cone_sample(Cone(2.0)); }
      │                                           ^^^^^^^^^^^ declared in common/cone.wgsl, not imported here
      │
      = add `import package::common::cone::cone_sample;`
    "#);
}

#[test]
fn text_that_would_spill_into_the_next_module() {
    let user = ("pass/a", "import package::common::b::b;\nfn a() { b(); }\n");
    assert_snapshot!(link_message(&[("common/b", "fn b() {\n    if true {\n}\n"), user]), @r#"
    error: unclosed `{`
      ┌─ common/b.wgsl:1:8
      │
    1 │ fn b() {
      │        ^ has no `}`
    "#);
    assert_snapshot!(link_message(&[("common/b", "struct S { a: f32\nfn b() {}"), user]), @r#"
    error: unclosed `{`
      ┌─ common/b.wgsl:1:10
      │
    1 │ struct S { a: f32
      │          ^ has no `}`
    "#);
    assert_snapshot!(link_message(&[("common/b", "fn b() {}\nconst C = 1"), user]), @r#"
    error: unfinished declaration
      ┌─ common/b.wgsl:2:11
      │
    2 │ const C = 1
      │           ^ expected `;` after this
    "#);
}

/// Locals, parameters, members and attributes may be named like what another module
/// declares; a local hides it only from its own statement's end to its block's end.
#[test]
fn local_names_are_no_uses() {
    let names = "fn position() {}\nfn level() {}\nfn flat() {}\nfn x() {}\nfn i() {}\nfn done() {}\n";
    let user = "import package::common::names::done;
struct S { position: vec3f, @align(16) level: f32 }
var<storage, read> data: array<S>;
fn f(level: f32, i: u32) -> f32 { return data[i].level + level; }
@fragment
fn g(@builtin(position) at: vec4f, @location(0) @interpolate(flat) kind: u32) -> @location(0) vec4f {
    let x = at.x; // x()
    for (var i = 0u; i < kind; i++) { let position = at.y; if position > x { done(); } }
    return vec4f(x); /* level() */
}
";
    link_last(&[("common/names", names), ("pass/a", user)]).unwrap().check().unwrap();

    let ended = "import package::common::names::done;\nfn f() { { let x = 1; done(); } x(); }\n";
    assert_snapshot!(link_message(&[("common/names", names), ("pass/a", ended)]), @r#"
    error: `x` is not imported
      ┌─ pass/a.wgsl:2:33
      │
    2 │ fn f() { { let x = 1; done(); } x(); }
      │                                 ^ declared in common/names.wgsl, not imported here
      │
      = add `import package::common::names::x;`
    "#);
    let itself = "import package::common::names::done;\nfn f() { let level = level(); }\n";
    assert_snapshot!(link_message(&[("common/names", names), ("pass/a", itself)]), @r#"
    error: `level` is not imported
      ┌─ pass/a.wgsl:2:22
      │
    2 │ fn f() { let level = level(); }
      │                      ^^^^^ declared in common/names.wgsl, not imported here
      │
      = add `import package::common::names::level;`
    "#);
}

#[test]
fn numbers_of_a_modules_own() {
    let text = "@group(0) @binding(0) var<uniform> a: vec4f;
@binding(1)
@group(0)
var b: texture_2d<f32>;
@group(2) var c: sampler;
@compute @workgroup_size(1) fn main(@builtin(workgroup_id) id: vec3u) {}
";
    assert_snapshot!(link_message(&[("pass/a", text)]), @r#"
    error: a module may not number its resources
      ┌─ pass/a.wgsl:1:1
      │
    1 │ @group(0) @binding(0) var<uniform> a: vec4f;
      │ ^^^^^^^^^^^^^^^^^^^^^ remove this: the linker gives `@group` and `@binding`

    error: a module may not number its resources
      ┌─ pass/a.wgsl:2:1
      │
    2 │ ╭ @binding(1)
    3 │ │ @group(0)
      │ ╰─────────^ remove this: the linker gives `@group` and `@binding`

    error: a module may not number its resources
      ┌─ pass/a.wgsl:5:1
      │
    5 │ @group(2) var c: sampler;
      │ ^^^^^^^^^ remove this: the linker gives `@group` and `@binding`
    "#);
}

#[test]
fn all_faults_at_once() {
    let broken = ("common/broken", "import package::nowhere::a;\nfn cone_sample() {}\n");
    let text = "import package::common::broken::b;\nimport package::common::cone::{Cone, c};\nimport x;\n";
    let message = link_message(&[CONE, broken, ("pass/a", text)]);
    assert_eq!(message.matches("error: ").count(), 5, "{message}");
}

#[test]
fn every_module_with_every_mount_and_each_fault_once() {
    let library = library(&[
        (
            "format/good/sample",
            "fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f { return vec4f(); }",
        ),
        (
            "format/bad/sample",
            "fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f { return 1; }",
        ),
        (
            "pass/a",
            "import package::format::sample::voxel_sample;\nfn a() -> vec4f { return voxel_sample(vec3f(), 0.0, vec3f()); }",
        ),
        ("pass/b", "import package::format::sample::voxel_sample;\nfn b() {}"),
        ("effect/glow", "fn effec() {}"),
    ]);
    assert_snapshot!(check_all(&library, &[("format", &["format/good", "format/bad"])]), @r#"
    error: effect `glow` must have `fn effect(surface: Surface, params: Params) -> vec4f`
      ┌─ effect/glow.wgsl:1:4
      │
    1 │ fn effec() {}
      │    ^^^^^ did you mean this?

    error: automatic conversions cannot convert `{AbstractInt}` to `vec4<f32>`
      ┌─ format/bad/sample.wgsl:1:77
      │
    1 │ fn voxel_sample(uvw: vec3f, level: f32, direction: vec3f) -> vec4f { return 1; }
      │                                                                             ^ this expression has type {AbstractInt}
    "#);
}
