//! A picture with its uncertainty.

/// A quantity at each pixel, row-major from the top left, linear.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The mean of each pixel's samples, in the quantity's unit.
    pub mean: Vec<[f32; 3]>,
    /// The mean's standard error, as the samples' own spread tells it: `√(Σ(s − mean)²/(n(n − 1)))`.
    /// Where all samples happen to agree it is 0, which for a rare event and few samples is too little.
    pub standard_error: Vec<[f32; 3]>,
}

/// Running mean and spread of one pixel (Welford 1962), in f64.
#[derive(Default)]
pub(crate) struct Statistics {
    count: f64,
    mean: [f64; 3],
    squares: [f64; 3],
}

impl Statistics {
    pub(crate) fn add(&mut self, sample: [f32; 3]) {
        self.count += 1.0;
        for (channel, value) in sample.map(f64::from).into_iter().enumerate() {
            let before = value - self.mean[channel];
            self.mean[channel] += before / self.count;
            self.squares[channel] += before * (value - self.mean[channel]);
        }
    }

    /// Mean and its standard error.
    pub(crate) fn finish(&self) -> ([f32; 3], [f32; 3]) {
        let error = |squares: f64| (squares / (self.count * (self.count - 1.0))).sqrt() as f32;
        (self.mean.map(|mean| mean as f32), self.squares.map(error))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_and_standard_error() {
        let mut statistics = Statistics::default();
        for value in [1.0, 2.0, 3.0, 6.0] {
            statistics.add([value, -value, 5.0]);
        }
        // Variance of the sample 14/3, so the error is √(14/12).
        let error = (14.0f32 / 12.0).sqrt();
        assert_eq!(statistics.finish(), ([3.0, -3.0, 5.0], [error, error, 0.0]));
    }
}
