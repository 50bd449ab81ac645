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

    /// Each pass's time over all frames.
    pub fn passes(&self) -> Vec<Pass> {
        let first = self.passes.first().map(Vec::as_slice).unwrap_or_default();
        let over_frames = |index: usize| -> Vec<f64> {
            self.passes.iter().filter_map(|frame| Some(frame.get(index)?.milliseconds)).collect()
        };
        first
            .iter()
            .enumerate()
            .map(|(index, pass)| {
                let (median_ms, spread_ms) = median_and_spread(&over_frames(index));
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

    #[test]
    fn the_total_is_of_frames_not_of_medians() {
        let mut frames = Frames::default();
        for (a, b) in [(1.0, 9.0), (2.0, 2.0), (9.0, 1.0)] {
            let pass = |name: &str, milliseconds| PassTime {
                pass: 0,
                name: name.into(),
                milliseconds,
                clock: Clock::Gpu,
            };
            frames.push(vec![pass("a", a), pass("b", b)], 20.0);
        }
        let medians: Vec<f64> = frames.passes().iter().map(|pass| pass.median_ms).collect();
        assert_eq!(medians, [2.0, 2.0]);
        assert_eq!(frames.total().0, 10.0);
    }
}
