//! What linking gives where nothing is wrong.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::library;
use voxlume_fault::Source;
use voxlume_shader::{Library, link};

#[test]
fn modules_once_dependencies_first() {
    let library = library(&[
        ("a", "const A = 1;"),
        ("b", "import package::a::A;\nconst B = A;"),
        (
            "c",
            "diagnostic(off, derivative_uniformity);\nimport package::b::B;\n// C\nimport package::a::{\n    A, // a\n};\nconst C = A + B;\n",
        ),
        ("d", "unused"),
    ]);
    let linked = link(&library, "c", &[]).unwrap();
    let lines: Vec<&str> = linked.wgsl.lines().map(str::trim_end).collect();
    assert_eq!(
        lines,
        [
            "diagnostic(off, derivative_uniformity);",
            "// a.wgsl",
            "const A = 1;",
            "// b.wgsl",
            "",
            "const B = A;",
            "// c.wgsl",
            "",
            "",
            "// C",
            "",
            "",
            "",
            "const C = A + B;",
            "",
        ]
    );
    linked.check().unwrap();
}

#[test]
fn cycles_of_imports() {
    let library = library(&[
        ("a", "import package::b::B;\nstruct A { a: f32 }\nfn f(b: B) -> f32 { return b.a.a; }"),
        ("b", "import package::a::A;\nstruct B { a: A }"),
    ]);
    assert!(link(&library, "a", &[]).unwrap().check().unwrap().function("f").is_some());
    assert!(link(&library, "b", &[]).unwrap().check().unwrap().function("f").is_some());
}

#[test]
fn mounts() {
    let library = library(&[
        ("format/one/sample", "fn voxel_sample() -> f32 { return 1.0; }"),
        (
            "format/six/sample",
            "import package::format::faces::FACES;\nfn voxel_sample() -> u32 { return FACES; }",
        ),
        ("format/six/faces", "const FACES = 6u;"),
        // By its full name, whatever is mounted.
        (
            "format/two/sample",
            "import package::format::six::faces::FACES;\nfn voxel_sample() -> u32 { return FACES; }",
        ),
        ("effect/glow", "fn effect() { _ = 1; }"),
        (
            "pass/a",
            "import package::format::sample::voxel_sample;\nimport package::effect::effect;\nfn a() { _ = voxel_sample(); effect(); }",
        ),
        ("pass/formatted", "const A = 1;"),
        ("nowhereatted", "const B = 1;"),
        ("pass/b", "import package::pass::formatted::A;"),
    ]);
    let result = |format| {
        let shader = link(&library, "pass/a", &[("format", format), ("effect", "effect/glow")])
            .unwrap()
            .check()
            .unwrap();
        assert!(shader.function("effect").is_some());
        shader.function("voxel_sample").unwrap().result
    };
    assert_eq!(result("format/one").as_deref(), Some("f32"));
    assert_eq!(result("format/six").as_deref(), Some("u32"));
    assert_eq!(result("format/two").as_deref(), Some("u32"));
    assert!(link(&library, "pass/a", &[("effect", "effect/glow")]).is_err());
    // A mount is whole names: `pass/form` is no part of `pass/formatted`.
    link(&library, "pass/b", &[("pass/form", "nowhere")]).unwrap();
}

/// Dense, in the order of the linked text, the same for every entry point; memory of invocations has none.
#[test]
fn resources_are_numbered() {
    let library = library(&[
        (
            "common/scene",
            "alias Image = texture_storage_2d<rgba8unorm, write>;\nvar<uniform> frame: vec4f; var image: Image;\nvar<private> sum: f32;",
        ),
        (
            "pass/a",
            "import package::common::scene::{frame, image, sum};
var<workgroup> shared_sum: f32;
var <storage, /* in place */ read_write> data: array<f32>;
fn local() -> f32 { var local = frame.x; return local; }
@compute @workgroup_size(1) fn first() { sum = frame.x + data[0]; shared_sum = sum; }
@compute @workgroup_size(1) fn second() { textureStore(image, vec2u(), vec4f(local())); data[0] = 1.0; }
",
        ),
    ]);
    let shader = link(&library, "pass/a", &[]).unwrap().check().unwrap();
    let bound = |entry| {
        let bindings = shader.bindings(entry).into_iter();
        bindings.map(|it| (it.group, it.binding, it.name, it.module)).collect::<Vec<_>>()
    };
    let at = |binding, name: &str, module: &str| (0, binding, name.to_owned(), module.to_owned());
    let (frame, data) = (at(0, "frame", "common/scene"), at(2, "data", "pass/a"));
    assert_eq!(bound("first"), [frame.clone(), data.clone()]);
    assert_eq!(bound("second"), [frame, at(1, "image", "common/scene"), data]);
}

#[test]
fn library_is_a_map_by_path() {
    let mut library = library(&[("b", "1"), ("a", "2")]);
    library.insert("b", Source::new("new", "3"));
    assert_eq!(library.paths().collect::<Vec<_>>(), ["a", "b"]);
    assert_eq!(&*library.get("b").unwrap().text, "3");
    assert!(library.get("c").is_none());
    let cone = Library::builtin();
    assert_eq!(cone.get("common/grid").unwrap().name, "wgsl/common/grid.wgsl");
}

/// A file's name is part of a comment in the linked text, never of the code.
#[test]
fn names_of_files_stay_in_their_comment() {
    let mut library = Library::empty();
    library.insert("a", Source::new("a\nconst A = 1;", "const A = 2;"));
    link(&library, "a", &[]).unwrap().check().unwrap();
}
