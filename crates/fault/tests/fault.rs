//! How faults look.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use insta::assert_snapshot;
use voxlume_fault::{Fault, Faults, SOURCE_LIMIT, Source, one_of};

#[test]
fn a_fault_without_a_place_is_one_line() {
    assert_snapshot!(Fault::new("no adapter"), @"error: no adapter");
    assert_snapshot!(Fault::new("no adapter").note("install mesa-vulkan-drivers\nor a GPU").note("second"), @r"
    error: no adapter
     = install mesa-vulkan-drivers
       or a GPU
     = second
    ");
}

#[test]
fn a_fault_shows_its_place() {
    let source = Source::new("pipelines/gi.ron", "(\n\n    // ü\n    format: \"sixface\",\n)");
    let at = source.text.find("\"sixface\"").unwrap();
    let label = one_of(["isotropic", "six_face", "sh2"]);
    let fault = Fault::new("unknown storage format `sixface`").at(&source, at..at + 9, label);
    assert_snapshot!(fault, @r#"
    error: unknown storage format `sixface`
      ┌─ pipelines/gi.ron:4:13
      │
    4 │     format: "sixface",
      │             ^^^^^^^^^ one of: isotropic, six_face, sh2
    "#);
    assert!(!fault.to_string().ends_with('\n'));
    assert_snapshot!(fault.note("see the book"), @r#"
    error: unknown storage format `sixface`
      ┌─ pipelines/gi.ron:4:13
      │
    4 │     format: "sixface",
      │             ^^^^^^^^^ one of: isotropic, six_face, sh2
      │
      = see the book
    "#);
}

#[test]
fn spans_over_lines_show_both_ends() {
    let source = Source::new("a.ron", "(\n  a: 1,\n  b: 2,\n)");
    assert_snapshot!(Fault::new("odd").at(&source, 4..17, "this"), @"
    error: odd
      ┌─ a.ron:2:3
      │
    2 │ ╭   a: 1,
    3 │ │   b: 2,
      │ ╰───────^ this
    ");
}

#[test]
fn any_span_renders() {
    for text in ["", "é", "aé\r\n漢字\tx", "\n\n", "🙂"] {
        let source = Source::new("x", text);
        for start in 0..text.len() + 3 {
            for end in 0..text.len() + 3 {
                let fault = Fault::new("m").at(&source, start..end, "l");
                assert!(fault.to_string().starts_with("error: m"), "{text:?} {start}..{end}");
            }
        }
        #[allow(clippy::reversed_empty_ranges)]
        let _ = Fault::new("m").at(&source, usize::MAX..0, "").to_string();
    }
    let source = Source::new("x", "aé漢b");
    assert_snapshot!(Fault::new("m").at(&source, 2..4, "l"), @"
    error: m
      ┌─ x:1:2
      │
    1 │ aé漢b
      │  ^^^ l
    ");
}

#[test]
fn faults_are_separated_by_a_blank_line() {
    let mut faults = Faults::default();
    assert!(faults.clone().into_result(7).is_ok());
    faults.push(Fault::new("first"));
    faults.extend(Faults::from(Fault::new("second")));
    assert_eq!(faults.gather::<()>(Err(Fault::new("third"))), None);
    assert_eq!(faults.gather(Ok::<_, Fault>(1)), Some(1));
    assert_eq!(faults.iter().count(), 3);
    assert_snapshot!(faults.into_result(()).unwrap_err(), @"
    error: first

    error: second

    error: third
    ");
}

#[test]
fn files_are_read_or_refused_with_their_path() {
    let folder = tempfile::tempdir().unwrap();
    let read = |name: &str| {
        let path = folder.path().join(name);
        let shown = folder.path().display().to_string();
        Source::read(&path).map(|s| s.text.to_string()).map_err(|e| e.to_string().replace(&shown, "DIR"))
    };
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("good.ron", "(é)".as_bytes());
    write("bytes.ron", b"(a\xff)");
    write("large.ron", &vec![b' '; SOURCE_LIMIT as usize + 1]);
    write("largest.ron", &vec![b' '; SOURCE_LIMIT as usize]);
    assert_eq!(read("good.ron"), Ok("(é)".into()));
    assert_eq!(read("largest.ron").unwrap().len() as u64, SOURCE_LIMIT);
    assert_eq!(read("none.ron"), Err("error: cannot read `DIR/none.ron`: no such file".into()));
    assert_eq!(read("bytes.ron"), Err("error: cannot read `DIR/bytes.ron`: not UTF-8 at byte 2".into()));
    assert_eq!(read("large.ron"), Err("error: cannot read `DIR/large.ron`: larger than 16 MiB".into()));
    assert!(read("").unwrap_err().starts_with("error: cannot read `DIR/`: "));
}

#[test]
fn faults_are_put_in_the_order_of_the_text() {
    let source = Source::new("a.ron", "abc");
    let mut faults = Faults::default();
    faults.push(Fault::new("second").at(&source, 2..3, ""));
    faults.push(Fault::new("first").at(&source, 0..1, ""));
    faults.push(Fault::new("placeless"));
    let messages: Vec<_> = faults.in_order().into_iter().map(|fault| fault.message).collect();
    assert_eq!(messages, ["placeless", "first", "second"]);
}
