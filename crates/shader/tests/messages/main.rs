//! Whole messages of every kind of fault, as users see them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod check;
#[path = "../common/mod.rs"]
mod common;
mod contract;
mod link;

use common::library;
use voxlume_fault::Faults;
use voxlume_shader::{Linked, link};

/// Links the last of some modules.
fn link_last(modules: &[(&str, &str)]) -> Result<Linked, Faults> {
    link(&library(modules), modules[modules.len() - 1].0, &[])
}

/// The message when the last of some modules does not link.
fn link_message(modules: &[(&str, &str)]) -> String {
    link_last(modules).unwrap_err().to_string()
}

/// The message when the last of some modules links but is not valid.
fn check_message(modules: &[(&str, &str)]) -> String {
    link_last(modules).unwrap().check().unwrap_err().to_string()
}
