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

/// A ratio of two means over the same samples: of weights where something is so, and of all weights.
#[derive(Default)]
pub(crate) struct Ratio {
    count: f64,
    weights: f64,
    so: f64,
    squares: f64,
    so_squares: f64,
}

impl Ratio {
    pub(crate) fn add(&mut self, weight: f64, so: bool) {
        self.count += 1.0;
        self.weights += weight;
        self.squares += weight * weight;
        if so {
            self.so += weight;
            self.so_squares += weight * weight;
        }
    }

    /// The ratio and its standard error to first order (Cochran 1977, "Sampling Techniques", eq. 6.12); 0 where
    /// nothing has weight, none without samples.
    pub(crate) fn finish(&self) -> Option<([f32; 3], [f32; 3])> {
        if self.count == 0.0 {
            return None;
        }
        if self.weights == 0.0 {
            return Some(([0.0; 3], [0.0; 3]));
        }
        let ratio = self.so / self.weights;
        let residues = self.so_squares * (1.0 - 2.0 * ratio) + ratio * ratio * self.squares;
        let variance = residues.max(0.0) / (self.weights * self.weights) * self.count / (self.count - 1.0);
        Some(([ratio as f32; 3], [variance.sqrt() as f32; 3]))
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

    #[test]
    fn a_ratio_weighs_its_samples() {
        let mut ratio = Ratio::default();
        [(1.0, true), (3.0, false), (0.0, false), (4.0, true)]
            .into_iter()
            .for_each(|(weight, so)| ratio.add(weight, so));
        // Residues w(V − 5/8): 3/8, −15/8, 0, 12/8.
        let error = ((9.0f64 + 225.0 + 144.0) / 64.0 / 64.0 * 4.0 / 3.0).sqrt() as f32;
        assert_eq!(ratio.finish(), Some(([0.625; 3], [error; 3])));
        assert_eq!(Ratio::default().finish(), None);
    }
}
