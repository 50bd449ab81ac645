//! What the book includes and links to is there.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::{Path, PathBuf};

use voxlume_tests::root;

fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(pages(&path));
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// What stands between `open` and `close`, each time.
fn between<'t>(text: &'t str, open: &'t str, close: &'t str) -> impl Iterator<Item = &'t str> {
    text.split(open).skip(1).map(move |rest| rest.split(close).next().unwrap())
}

fn faults(text: &str, folder: &Path) -> Vec<String> {
    let mut faults = Vec::new();
    for include in between(text, "{{#include ", "}}") {
        let (file, anchor) = include.trim().split_once(':').unwrap_or((include.trim(), ""));
        let Ok(included) = std::fs::read_to_string(folder.join(file)) else {
            faults.push(format!("includes `{file}`, which isn't there"));
            continue;
        };
        let marks = ["ANCHOR: ", "ANCHOR_END: "].map(|mark| format!("{mark}{anchor}"));
        if !anchor.is_empty() && !marks.iter().all(|mark| included.lines().any(|line| line.ends_with(mark))) {
            faults.push(format!("`{file}` has no anchor `{anchor}`"));
        }
    }
    for link in between(text, "](", ")").filter(|link| !link.contains("://") && !link.starts_with('#')) {
        let file = link.split('#').next().unwrap();
        if !folder.join(file).exists() {
            faults.push(format!("links to `{file}`, which isn't there"));
        }
    }
    faults
}

#[test]
fn includes_and_links_of_the_book_are_there() {
    let source = root().join("book/src");
    let pages = pages(&source);
    assert!(pages.len() > 8);
    let summary = std::fs::read_to_string(source.join("SUMMARY.md")).unwrap();
    for page in pages {
        let text = std::fs::read_to_string(&page).unwrap();
        let faults = faults(&text, page.parent().unwrap());
        assert!(faults.is_empty(), "{}: {}", page.display(), faults.join(", "));
        let name = page.strip_prefix(&source).unwrap().to_str().unwrap();
        assert!(
            name == "SUMMARY.md" || summary.contains(&format!("({name})")),
            "{name} is not in the summary"
        );
    }
}

#[test]
fn what_is_missing_is_noticed() {
    let folder = root().join("book/src");
    let faults = |text: &str| faults(text, &folder);
    assert_eq!(faults("{{#include nothing.rs}}"), ["includes `nothing.rs`, which isn't there"]);
    let anchor = "{{#include ../../crates/sh3/src/main.rs:nothing}}";
    assert_eq!(faults(anchor), ["`../../crates/sh3/src/main.rs` has no anchor `nothing`"]);
    assert_eq!(faults("[a](nothing.md#b)"), ["links to `nothing.md`, which isn't there"]);
    assert!(faults("[a](index.md#b) [c](https://example.org) [d](#e)").is_empty());
}

/// Every test that the errata page names exists.
#[test]
fn the_errata_page_names_tests_that_exist() {
    let page = std::fs::read_to_string(root().join("book/src/errata.md")).unwrap();
    let tests = std::fs::read_to_string(root().join("tests/tests/errata.rs")).unwrap();
    let rows: Vec<&str> = page
        .lines()
        .filter(|line| line.starts_with("| RAU") || line.starts_with("| DVS") || line.starts_with("| all"))
        .collect();
    assert!(rows.len() >= 13);
    for row in rows {
        let name = row.rsplit('`').nth(1).unwrap();
        assert!(tests.contains(&format!("fn {name}()")), "{name}");
    }
}
