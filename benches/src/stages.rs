//! Progress on stderr.

use voxlume_measure::Progress;

/// Tells on stderr of each piece of work.
#[derive(Debug)]
pub struct Stages;

impl Progress for Stages {
    fn stage(&mut self, what: String) {
        eprintln!("{what}");
    }

    fn repeated(&mut self, _: String) {}

    fn share(&mut self, _: &str, _: f32) {}
}
