//! The times of some frames.

use voxlume::{Clock, PassTime};
use voxlume_report::Pass;

use crate::statistics::median_and_spread;

/// The times of some frames.
#[derive(Debug, Default)]
pub struct Frames {
    /// Of each frame, its passes.
    passes: Vec<Vec<PassTime>>,
    /// Of each frame, milliseconds from the first command to the last result.
    wall: Vec<f64>,
}

impl Frames {
    /// Adds a frame.
    pub fn push(&mut self, passes: Vec<PassTime>, wall_ms: f64) {
        self.passes.push(passes);
        self.wall.push(wall_ms);
    }

    /// How many.
    pub fn count(&self) -> usize {
        self.wall.len()
    }

    /// Names of the passes that each frame ran.
    pub fn ran(&self) -> Vec<Vec<String>> {
        let names = |frame: &Vec<PassTime>| frame.iter().map(|pass| pass.name.clone()).collect();
        self.passes.iter().map(names).collect()
    }

    /// Each pass's time over the frames that ran it, in the order of execution.
    pub fn passes(&self) -> Vec<Pass> {
        let mut all: Vec<&PassTime> = Vec::new();
        for pass in self.passes.iter().flatten() {
            if !all.iter().any(|known| known.name == pass.name) {
                all.push(pass);
            }
        }
        all.sort_by_key(|pass| pass.pass);
        let over_frames = |name: &str| -> Vec<f64> {
            let times = self.passes.iter().flatten().filter(|pass| pass.name == name);
            times.map(|pass| pass.milliseconds).collect()
        };
        all.into_iter()
            .map(|pass| {
                let (median_ms, spread_ms) = median_and_spread(&over_frames(&pass.name));
                let clock = match pass.clock {
                    Clock::Gpu => "gpu",
                    Clock::Wall => "wall",
                };
                Pass { name: pass.name.clone(), median_ms, spread_ms, clock: clock.to_owned() }
            })
            .collect()
    }

    /// Median and interquartile range of the host's clock, milliseconds.
    pub fn wall(&self) -> (f64, f64) {
        median_and_spread(&self.wall)
    }

    /// Median and interquartile range of the sum of all passes, milliseconds.
    pub fn total(&self) -> (f64, f64) {
        let sums: Vec<f64> =
            self.passes.iter().map(|frame| frame.iter().map(|pass| pass.milliseconds).sum()).collect();
        median_and_spread(&sums)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pass(index: usize, name: &str, milliseconds: f64) -> PassTime {
        PassTime { pass: index, name: name.into(), milliseconds, clock: Clock::Gpu }
    }

    #[test]
    fn a_pass_that_some_frames_ran() {
        let mut frames = Frames::default();
        frames.push(vec![pass(1, "b", 4.0)], 20.0);
        frames.push(vec![], 20.0);
        frames.push(vec![pass(0, "a", 3.0), pass(1, "b", 2.0)], 20.0);
        let medians: Vec<_> = frames.passes().into_iter().map(|pass| (pass.name, pass.median_ms)).collect();
        assert_eq!(medians, [("a".to_owned(), 3.0), ("b".to_owned(), 3.0)]);
        assert_eq!(frames.ran(), [vec!["b"], vec![], vec!["a", "b"]]);
    }

    #[test]
    fn the_total_is_of_frames_not_of_medians() {
        let mut frames = Frames::default();
        for (a, b) in [(1.0, 9.0), (2.0, 2.0), (9.0, 1.0)] {
            frames.push(vec![pass(0, "a", a), pass(1, "b", b)], 20.0);
        }
        let medians: Vec<f64> = frames.passes().iter().map(|pass| pass.median_ms).collect();
        assert_eq!(medians, [2.0, 2.0]);
        assert_eq!(frames.total().0, 10.0);
    }
}
