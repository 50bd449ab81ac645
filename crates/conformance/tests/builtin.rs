//! Every built-in format in every encoding passes the suite.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Encodings, Formats, Gpu, Library};

#[test]
fn every_builtin_format_passes() {
    let gpu = Gpu::open(None).unwrap();
    let library = Library::builtin();
    let mut failures = Vec::new();
    for format in Formats::builtin().iter() {
        for encoding in Encodings::builtin().iter() {
            let report = voxlume_conformance::run(&gpu, format, &library, encoding).unwrap();
            println!("{report}");
            if !report.passes() {
                failures.push(report.to_string());
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
