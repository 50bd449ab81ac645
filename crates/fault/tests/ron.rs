//! RON with places: what is read, and how its faults look.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use insta::assert_snapshot;
use voxlume_fault::ron::{Document, Fields, FromRon};
use voxlume_fault::{Fault, Faults, Source};

fn parse(text: &str) -> Result<Document, Fault> {
    Document::parse(&Source::new("a.ron", text))
}

fn get<T: FromRon>(text: &str) -> Result<T, String> {
    parse(text).map_err(|e| e.to_string())?.root().get().map_err(|e| e.to_string())
}

const ALL: &str = r##"#![enable(implicit_some)]
// comment ( [ {
Root /* nested /* " */ ' */ (
    r#name: "a (\" b", // ,
    raw: r#"x " ) "#, bytes: b"\")", letter: '\'', quote: '"',
    list: [1, (2), [3,], {"k": [4]},], unit: (),
    nested: Inner(x: -1.5e3, y: inf), word: isotropic,
    map: {"a": 1, 'b': (c: 2)},
    größe: 1, /* end */
) // end"##;

#[test]
fn every_value_keeps_its_place() {
    let document = parse(ALL).unwrap();
    let root = document.root();
    assert_eq!((root.name(), root.delimiter()), (Some("Root"), Some('(')));
    assert!(root.text().starts_with("Root") && root.text().ends_with(')'));
    let fields = root.fields().unwrap();
    let shown: Vec<_> = fields.iter().map(|f| format!("{} = {}", f.name, f.value.text())).collect();
    assert_eq!(
        shown,
        [
            r#"name = "a (\" b""#,
            r###"raw = r#"x " ) "#"###,
            r#"bytes = b"\")""#,
            r"letter = '\''",
            r#"quote = '"'"#,
            r#"list = [1, (2), [3,], {"k": [4]},]"#,
            "unit = ()",
            "nested = Inner(x: -1.5e3, y: inf)",
            "word = isotropic",
            r#"map = {"a": 1, 'b': (c: 2)}"#,
            "größe = 1",
        ]
    );
    for field in &fields {
        assert_eq!(&ALL[field.value.span()], field.value.text());
        assert!(ALL[field.span.clone()].ends_with(field.name));
    }
    let items = |i: usize| fields[i].value.items().unwrap().iter().map(|n| n.text()).collect::<Vec<_>>();
    assert_eq!(items(5), ["1", "(2)", "[3,]", r#"{"k": [4]}"#]);
    assert!(items(6).is_empty());
    let entries = fields[9].value.entries().unwrap();
    let entries: Vec<_> = entries.iter().map(|(k, v)| (k.text(), v.text())).collect();
    assert_eq!(entries, [("\"a\"", "1"), ("'b'", "(c: 2)")]);
    assert_eq!(fields[7].value.name(), Some("Inner"));
    assert_eq!(fields[8].value.name(), Some("isotropic"));
    assert_eq!((fields[0].value.name(), fields[5].value.name()), (None, None));
    assert_eq!(fields[0].value.get::<String>().unwrap(), "a (\" b");
    assert_eq!(fields[1].value.get::<String>().unwrap(), "x \" ) ");
    assert!(parse("Name").unwrap().root().fields().unwrap().is_empty());
}

#[test]
fn values_are_read() {
    assert_eq!(get::<f64>("1"), Ok(1.0));
    assert_eq!(get::<f32>("-1.5e-3"), Ok(-1.5e-3));
    assert_eq!(get::<u32>("0x10"), Ok(16));
    assert_eq!(get::<bool>("true"), Ok(true));
    assert_eq!(get::<[f64; 3]>("(1, 2.5, -3)"), Ok([1.0, 2.5, -3.0]));
    assert_eq!(get::<[f64; 3]>("[1, 2.5, -3]"), Ok([1.0, 2.5, -3.0]));
    assert_eq!(get::<Vec<[u32; 2]>>("[(1, 2), (3, 4)]"), Ok(vec![[1, 2], [3, 4]]));
    assert_eq!(get::<String>("\"a\\u{e9}\\n\""), Ok("aé\n".into()));
    let optional: Option<u32> = parse("7").unwrap().root().deserialize().unwrap();
    assert_eq!(optional, Some(7));
}

#[test]
fn syntax_errors() {
    let fault = |text: &str| parse(text).unwrap_err().to_string();
    assert_snapshot!(fault("(\n    é: 1\n    b: 2,\n)"), @"
    error: expected comma
      ┌─ a.ron:3:5
      │
    3 │     b: 2,
      │     ^
    ");
    assert_snapshot!(fault("(a: [1, 2)"), @"
    error: expected comma
      ┌─ a.ron:1:10
      │
    1 │ (a: [1, 2)
      │          ^
    ");
    assert_snapshot!(fault("(a: \"漢\\q\")"), @r#"
    error: unknown escape character
      ┌─ a.ron:1:6
      │
    1 │ (a: "漢\q")
      │      ^^^^
    "#);
    assert_snapshot!(fault("(a: \"x)\n"), @r#"
    error: expected end of string
      ┌─ a.ron:1:5
      │
    1 │ (a: "x)
      │     ^
    "#);
    assert_snapshot!(fault("(a: 1)\n  x"), @"
    error: non-whitespace trailing characters
      ┌─ a.ron:2:3
      │
    2 │   x
      │   ^
    ");
    assert_snapshot!(fault("(a: 1,\n"), @"
    error: unexpected end of RON
      ┌─ a.ron:2:1
      │
    2 │
      │ ^
    ");
    assert_snapshot!(fault("#![enable(magic)]\n()"), @"
    error: no RON extension named `magic`
      ┌─ a.ron:1:11
      │
    1 │ #![enable(magic)]
      │           ^^^^^
    ");
    assert!(fault(&"[".repeat(100_000)).starts_with("error: nested too deeply\n"));
    assert!(fault("").starts_with("error: unexpected end of RON\n"));
}

#[test]
fn wrong_types() {
    assert_snapshot!(get::<[f32; 3]>("(1, \"x\", NaN)").unwrap_err(), @r#"
    error: expected a number, found a string
      ┌─ a.ron:1:5
      │
    1 │ (1, "x", NaN)
      │     ^^^

    error: expected a finite number, found `NaN`
      ┌─ a.ron:1:10
      │
    1 │ (1, "x", NaN)
      │          ^^^
    "#);
    assert_snapshot!(get::<Vec<f32>>("[1e39, -inf, 1e999]").unwrap_err(), @"
    error: expected a number within ±3.4e38, found `1e39`
      ┌─ a.ron:1:2
      │
    1 │ [1e39, -inf, 1e999]
      │  ^^^^

    error: expected a finite number, found `-inf`
      ┌─ a.ron:1:8
      │
    1 │ [1e39, -inf, 1e999]
      │        ^^^^

    error: expected a finite number, found `1e999`
      ┌─ a.ron:1:14
      │
    1 │ [1e39, -inf, 1e999]
      │              ^^^^^
    ");
    assert_snapshot!(get::<u32>("-1").unwrap_err(), @"
    error: expected a whole number from 0 to 4294967295, found `-1`
      ┌─ a.ron:1:1
      │
    1 │ -1
      │ ^^
    ");
    let first = |result: Result<(), String>| result.unwrap_err().lines().next().unwrap().to_owned();
    assert_eq!(
        first(get::<u32>("1.5").map(drop)),
        "error: expected a whole number from 0 to 4294967295, found `1.5`"
    );
    assert_eq!(first(get::<bool>("[]").map(drop)), "error: expected `true` or `false`, found a list");
    assert_eq!(first(get::<String>("Ball(r: 1)").map(drop)), "error: expected a string, found `Ball(...)`");
    assert_eq!(first(get::<[f32; 2]>("(1, 2, 3)").map(drop)), "error: expected 2 values, found 3");
    assert_eq!(
        first(get::<[f32; 2]>("(x: 1, y: 3)").map(drop)),
        "error: expected 2 values `(...)`, found `(...)`"
    );
    assert_eq!(first(get::<[f32; 2]>("7").map(drop)), "error: expected 2 values `(...)`, found `7`");
    assert_eq!(first(get::<Vec<f32>>("{1: 2}").map(drop)), "error: expected a list `[...]`, found a map");
    let map = parse("[1]").unwrap().root().entries().map(drop).map_err(|e| e.to_string());
    assert_eq!(first(map), "error: expected a map `{key: value, ...}`, found a list");
}

#[test]
fn choices() {
    let choice = |text: &str| {
        let document = parse(text).unwrap();
        document.root().choice("storage format", ["isotropic", "six_face", "sh2"]).map_err(|e| e.to_string())
    };
    assert_eq!(choice("sh2"), Ok("sh2"));
    assert_eq!(choice("\"sh2\""), Ok("sh2"));
    assert_snapshot!(choice("sixface").unwrap_err(), @"
    error: unknown storage format `sixface`
      ┌─ a.ron:1:1
      │
    1 │ sixface
      │ ^^^^^^^ did you mean `six_face`? one of: isotropic, six_face, sh2
    ");
    assert_snapshot!(choice("[1]").unwrap_err(), @"
    error: expected storage format, found a list
      ┌─ a.ron:1:1
      │
    1 │ [1]
      │ ^
    ");
}

#[test]
fn all_faults_of_a_struct_at_once() {
    let document =
        parse("Ball(\n    radus: 1,\n    centre: (0, x, 2),\n    colour: 1, colour: 2,\n    größe: 3)")
            .unwrap();
    let mut faults = Faults::default();
    let mut fields = Fields::of(document.root()).unwrap();
    assert_eq!(fields.required::<f32>("radius", &mut faults), None);
    assert_eq!(fields.required::<[f32; 3]>("centre", &mut faults), None);
    assert_eq!(fields.optional::<f32>("colour", &mut faults), Some(1.0));
    assert_eq!(fields.or("segments", 8u32, &mut faults), 8);
    fields.finish(&mut faults);
    assert_snapshot!(faults, @"
    error: missing field `radius` of `Ball`
      ┌─ a.ron:1:1
      │
    1 │ Ball(
      │ ^^^^ needed here

    error: expected a number, found `x`
      ┌─ a.ron:3:17
      │
    3 │     centre: (0, x, 2),
      │                 ^

    error: unknown field `radus`
      ┌─ a.ron:2:5
      │
    2 │     radus: 1,
      │     ^^^^^ did you mean `radius`? one of: radius, centre, colour, segments

    error: field `colour` given twice
      ┌─ a.ron:4:16
      │
    4 │     colour: 1, colour: 2,
      │                ^^^^^^ the second

    error: unknown field `größe`
      ┌─ a.ron:5:5
      │
    5 │     größe: 3)
      │     ^^^^^ one of: radius, centre, colour, segments
    ");
    assert_snapshot!(Fields::of(parse("(1, 2)").unwrap().root()).unwrap_err(), @"
    error: expected fields `(name: value, ...)`, found `(...)`
      ┌─ a.ron:1:1
      │
    1 │ (1, 2)
      │ ^
    ");
}
