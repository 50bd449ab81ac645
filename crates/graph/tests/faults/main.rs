//! Whole messages of every kind of fault, as users see them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/mod.rs"]
mod common;
mod effects;
mod graph;
mod grids;
mod images;
mod params;
mod words;

use common::message;

/// Else every message below could be of something else.
#[test]
fn unchanged_it_has_no_fault() {
    assert_eq!(message(&[]), "no fault");
}
