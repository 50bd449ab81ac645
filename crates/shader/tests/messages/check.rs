//! What naga finds, in the author's own file.

use insta::assert_snapshot;

use crate::{check_message, link_last};

const CONE: (&str, &str) = (
    "common/cone",
    "// The aperture is ½ of the angle.\nfn area(r: f32) -> f32 { return r * r; }\nstruct Cone { aperture: f32 }\n",
);

/// Imports, comments and characters of several bytes above must not move the place.
#[test]
fn typo_in_an_expression() {
    let text = "// ½ é\nimport package::common::cone::{\n    area, // ½\n    Cone,\n};\n\nfn a(radius: f32) -> f32 {\n    return /* ½ */ area(raduis) * 2.0;\n}\n";
    assert_snapshot!(check_message(&[CONE, ("pass/a", text)]), @r#"
    error: no definition in scope for identifier: `raduis`
      ┌─ pass/a.wgsl:8:25
      │
    8 │     return /* ½ */ area(raduis) * 2.0;
      │                         ^^^^^^ unknown identifier
      │
      = did you mean `radius`?
    "#);
}

#[test]
fn unknown_type_or_name() {
    assert_snapshot!(check_message(&[CONE, ("pass/a", "fn a(cone: Cone) {}\n")]), @r#"
    error: no definition in scope for identifier: `Cone`
      ┌─ pass/a.wgsl:1:12
      │
    1 │ fn a(cone: Cone) {}
      │            ^^^^ unknown identifier
      │
      = add `import package::common::cone::Cone;`
    "#);
    assert_snapshot!(check_message(&[("pass/a", "struct Surface { a: f32 }\nfn a(s: Surfce) {}\n")]), @r#"
    error: no definition in scope for identifier: `Surfce`
      ┌─ pass/a.wgsl:2:9
      │
    2 │ fn a(s: Surfce) {}
      │         ^^^^^^ unknown identifier
      │
      = did you mean `Surface`?
    "#);
    assert_snapshot!(check_message(&[("pass/a", "fn a() { nothing_like_it(); }\n")]), @r#"
    error: no definition in scope for identifier: `nothing_like_it`
      ┌─ pass/a.wgsl:1:10
      │
    1 │ fn a() { nothing_like_it(); }
      │          ^^^^^^^^^^^^^^^ unknown identifier
    "#);
}

#[test]
fn syntax() {
    assert_snapshot!(check_message(&[("pass/a", "fn a() {\n    let b = 1\n    let c = 2;\n}\n")]), @r#"
    error: expected `;`, found "let"
      ┌─ pass/a.wgsl:3:5
      │
    3 │     let c = 2;
      │     ^^^ expected `;`
    "#);
}

#[test]
fn mismatched_types() {
    assert_snapshot!(check_message(&[("pass/a", "fn a(b: vec3f, c: vec2f) -> vec3f {\n    return b * c;\n}\n")]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:2:12
      │
    2 │     return b * c;
      │            ^^^^^ `*` cannot take vec3f and vec2f
    "#);
    assert_snapshot!(check_message(&[("pass/a", "fn a(b: vec3f) -> f32 {\n    return b * 2.0;\n}\n")]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:2:5
      │
    2 │     return b * 2.0;
      │     ^^^^^^^^^^^^^^^ returns vec3f, declared to return f32
    "#);
    assert_snapshot!(check_message(&[("pass/a", "fn a(b: f32) -> f32 {\n    if b > 0.0 { return b; }\n}\n")]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:1:1
      │
    1 │ ╭ fn a(b: f32) -> f32 {
    2 │ │     if b > 0.0 { return b; }
    3 │ │ }
      │ ╰─^ some path returns nothing, declared to return f32
    "#);
    assert_snapshot!(check_message(&[("pass/a", "fn a(b: vec3f) {\n    if b.x { return; }\n}\n")]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:2:8
      │
    2 │     if b.x { return; }
      │        ^^^ the condition is f32, must be bool
    "#);
    assert_snapshot!(check_message(&[("pass/a", "fn a(b: vec3f) {\n    var c = 1.0;\n    c = b;\n}\n")]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:3:5
      │
    3 │     c = b;
      │     ^^^^^ vec3f cannot be stored through ptr<function, f32>
    "#);
    let call = "import package::common::cone::area;\nfn a(b: vec3f) -> f32 {\n    return area(b);\n}\n";
    assert_snapshot!(check_message(&[CONE, ("pass/a", call)]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:3:12
      │
    3 │     return area(b);
      │            ^^^^^^^ argument 1 of `area` is vec3f, must be f32
    "#);
    let entry = "@compute @workgroup_size(1)\nfn main() {\n    let a = vec2f() + vec3f();\n}\n";
    assert_snapshot!(check_message(&[("pass/a", entry)]), @r#"
    error: invalid entry point `main`
      ┌─ pass/a.wgsl:3:13
      │
    3 │     let a = vec2f() + vec3f();
      │             ^^^^^^^^^^^^^^^^^ `+` cannot take vec2f and vec3f
    "#);
}

#[test]
fn writing_what_is_read_only() {
    let text = "var<storage, read> data: array<f32>;\nfn a() {\n    data[0] = 1.0;\n}\n";
    assert_snapshot!(check_message(&[("pass/a", text)]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:3:5
      │
    3 │     data[0] = 1.0;
      │     ^^^^^^^ cannot be written to
    "#);
}

#[test]
fn layout_that_a_uniform_cannot_have() {
    let text = "struct Params { on: bool }\nvar<uniform> params: Params;\n";
    assert_snapshot!(check_message(&[("pass/a", text)]), @r#"
    error: invalid variable `params`
      ┌─ pass/a.wgsl:2:1
      │
    2 │ var<uniform> params: Params;
      │ ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ The type is not host-shareable
    "#);
}

/// The numbers that the linker writes in front of resources must not move the place of what comes after them.
#[test]
fn after_resources() {
    let frame = ("common/frame", "var<uniform> frame: vec4f; var<uniform> more: vec4f;\n");
    let imports = "import package::common::frame::frame;\n";
    let resources = "var<storage, read> a: array<f32>; /* ½ */ var b: texture_2d<f32>;";
    let message = |rest: &str| check_message(&[frame, ("pass/a", &format!("{imports}{resources} {rest}"))]);
    assert_snapshot!(message("fn f() -> f32 { return fram.x; }\n"), @r#"
    error: no definition in scope for identifier: `fram`
      ┌─ pass/a.wgsl:2:90
      │
    2 │ var<storage, read> a: array<f32>; /* ½ */ var b: texture_2d<f32>; fn f() -> f32 { return fram.x; }
      │                                                                                          ^^^^ unknown identifier
      │
      = did you mean `frame`?
    "#);
    assert_snapshot!(message("var c: texture_2d<f33>;\n"), @r#"
    error: no definition in scope for identifier: `f33`
      ┌─ pass/a.wgsl:2:85
      │
    2 │ var<storage, read> a: array<f32>; /* ½ */ var b: texture_2d<f32>; var c: texture_2d<f33>;
      │                                                                                     ^^^ unknown identifier
      │
      = did you mean `f32`?
    "#);
    assert_snapshot!(message("fn f() -> f32 { return frame; }\nvar c: sampler;\n"), @r#"
    error: invalid function `f`
      ┌─ pass/a.wgsl:2:83
      │
    2 │ var<storage, read> a: array<f32>; /* ½ */ var b: texture_2d<f32>; fn f() -> f32 { return frame; }
      │                                                                                   ^^^^^^^^^^^^^ returns vec4f, declared to return f32
    "#);
    assert_snapshot!(message("\nvar d: f32;\n"), @r#"
    error: invalid variable `d`
      ┌─ pass/a.wgsl:3:1
      │
    3 │ var d: f32;
      │ ^^^^^^^^^^^ Type isn't compatible with address space Handle
    "#);
    assert_snapshot!(message("var<storage> d: f32\n;var<uniform> e: array<f32>;\n"), @r#"
    error: invalid variable `e`
      ┌─ pass/a.wgsl:3:2
      │
    3 │ ;var<uniform> e: array<f32>;
      │  ^^^^^^^^^^^^^^^^^^^^^^^^^^^ The array stride 4 is not a multiple of the required alignment 16
    "#);
}

#[test]
fn what_only_some_devices_can_do() {
    assert_snapshot!(check_message(&[CONE, ("pass/a", "// Half.\nenable f16;\nimport package::common::cone::Cone;\nfn a() {}\n")]), @r#"
    error: the `f16` extension is not supported in the current environment
      ┌─ pass/a.wgsl:2:8
      │
    2 │ enable f16;
      │        ^^^ unsupported enable-extension
    "#);
    assert_snapshot!(check_message(&[("pass/a", "fn a() -> f32 {\n    return subgroupAdd(1.0);\n}\n")]), @r#"
    error: invalid function `a`
      ┌─ pass/a.wgsl:2:12
      │
    2 │     return subgroupAdd(1.0);
      │            ^^^^^^^^^^^ needs an optional feature: SUBGROUP
    "#);
    let textures = "var a: texture_storage_2d<r16float, write>;
var b: texture_storage_3d<rgba16float, read_write>;
var c: texture_storage_3d<r32uint, read_write>;
var d: texture_storage_3d<rgba16float, write>;
";
    assert_snapshot!(check_message(&[("pass/a", textures)]), @r#"
    error: storage texture `a`: r16float is no WebGPU default
      ┌─ pass/a.wgsl:1:1
      │
    1 │ var a: texture_storage_2d<r16float, write>;
      │ ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ one of: r32float, r32sint, r32uint, rg32float, rg32sint, rg32uint, rgba16float, rgba16sint, rgba16uint, rgba32float, rgba32sint, rgba32uint, rgba8sint, rgba8snorm, rgba8uint, rgba8unorm

    error: storage texture `b`: rgba16float with read_write access is no WebGPU default
      ┌─ pass/a.wgsl:2:1
      │
    2 │ var b: texture_storage_3d<rgba16float, read_write>;
      │ ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ one of: r32float, r32sint, r32uint
    "#);
}

#[test]
fn what_every_device_can_do() {
    let text = "var sky: texture_cube_array<f32>;
@fragment
fn main(@builtin(sample_index) i: u32) -> @location(0) vec4f {
    return vec4f(vec3f(f32(textureNumLevels(sky))), unpack2x16float(pack2x16float(vec2f(f32(i)))).x);
}
";
    link_last(&[("pass/a", text)]).unwrap().check().unwrap();
}

#[test]
fn entry_points() {
    assert_snapshot!(check_message(&[("pass/a", "@compute @workgroup_size(0)\nfn main() {}\n")]), @r#"
    error: invalid entry point `main`
      ┌─ pass/a.wgsl:2:4
      │
    2 │ fn main() {}
      │    ^^^^ Workgroup size is out of range
    "#);
    assert_snapshot!(check_message(&[("pass/a", "override SIZE: u32 = 64;\n@compute @workgroup_size(SIZE)\nfn main() {}\n")]), @r#"
    error: the workgroup size of `main` depends on an override
      ┌─ pass/a.wgsl:3:4
      │
    3 │ fn main() {}
      │    ^^^^ write a number or a `const`
    "#);
}

/// Hostile texts give a message, not an abort.
#[test]
fn hostile_texts() {
    for unit in ["(", "{", "fn f(", "/*", "struct S {", "a<", "import ", "@", "[", "fn f() {", "-", "if a {"]
    {
        let text = format!("fn a() -> f32 {{ return {}", unit.repeat(20_000));
        for text in [text.clone(), format!("{text};"), unit.repeat(20_000) + "}", unit.repeat(20_000) + ";"] {
            let linked = link_last(&[("pass/a", &text)]);
            assert!(linked.and_then(|linked| linked.check()).is_err(), "{unit}");
        }
    }
}

/// As long as can be, these still compile on a thread of 2 MiB; longer ones are refused.
#[test]
fn limits() {
    type Text = fn(usize) -> String;
    let texts: [(Text, usize); 5] = [
        (|n| format!("fn f(a: f32) -> f32 {{ return a{}; }}\n", "+a".repeat(n)), 999),
        (
            |n| {
                let chain = "else if a {}".repeat(n);
                format!("fn f(a: bool) {{ if a {{}} {chain} }}\nfn g(a: bool) {{ if a {{}} {chain} }}\n")
            },
            250,
        ),
        (
            |n| {
                (1..n).rev().map(|i| format!("const A{i} = A{};", i - 1)).collect::<String>()
                    + "const A0 = 1;"
            },
            2000,
        ),
        (
            |n| {
                (1..n).rev().map(|i| format!("fn f{i}() {{ f{}(); }}", i - 1)).collect::<String>()
                    + "fn f0() {}"
            },
            2000,
        ),
        (|n| (0..n).map(|i| format!("var<uniform> a{i}: f32;")).collect(), 1000),
    ];
    let mut messages = Vec::new();
    for (text, most) in texts {
        link_last(&[("pass/a", &text(most))]).unwrap().check().unwrap();
        let faults = link_last(&[("pass/a", &text(most + 1))]).unwrap_err();
        let fault = faults.iter().next().unwrap();
        messages.push(format!(
            "{}: {}",
            fault.message,
            fault.place.as_ref().map_or("", |place| &place.label)
        ));
    }
    assert_snapshot!(messages.join("\n"), @r#"
    too long to compile safely: more than 2000 tokens in one expression
    too long to compile safely: more than 250 `else` in one function
    `pass/a` links more than 2000 declarations: 
    `pass/a` links more than 2000 declarations: 
    `pass/a` links more than 1000 resources:
    "#);
}
