//! The format passes the suite that every format passes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

// ANCHOR: suite
use voxlume::{Encodings, Formats, Gpu, Library};
use voxlume_sh3::{Sh3, register};

#[test]
fn sh3_passes_the_suite() {
    let (mut formats, mut library) = (Formats::builtin(), Library::builtin());
    register(&mut formats, &mut library);
    let gpu = Gpu::open(None).unwrap();
    for encoding in Encodings::builtin().iter() {
        let report = voxlume_conformance::run(&gpu, &Sh3, &library, encoding).unwrap();
        assert!(report.passes(), "{report}");
    }
}
// ANCHOR_END: suite
