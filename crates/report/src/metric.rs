//! Error figures.

use std::fmt;

use serde::{Deserialize, Serialize};

/// How an image differs from its reference, over the pixels that count and their three channels, linear, in
/// the unit of the quantity.
///
/// `d` is image − reference, `r` the reference, `s` the reference's standard error. The reference's own noise is
/// no error of the image and independent of it, so its expected share `s²` is taken off the squares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// Root mean square error: `√max(0, mean(d² − s²))`.
    pub rmse: f64,
    /// Relative mean square error: `max(0, mean((d² − s²)/(r² + ε)))` with `ε = (mean(r)/10)²`, so that dark pixels
    /// don't outweigh all others and a scene's unit doesn't matter. None for a reference that is black.
    pub rel_mse: Option<f64>,
    /// Signed bias `mean(d)`: above 0 is too bright.
    pub bias: f64,
    /// `mean(d)/mean(r)`. None for a reference of mean 0.
    pub bias_rel: Option<f64>,
    /// 99th percentile of `|d|`, interpolated between values. Contains the reference's noise.
    pub p99: f64,
    /// Mean FLIP of the tone-mapped image, in \[0,1\], at 67 pixels a degree. Contains the reference's noise.
    pub flip: f64,
    /// `√mean(s²)`.
    pub reference_se: f64,
}

/// What is to be said beside a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Note {
    /// The RMSE is less than the reference's standard error.
    BelowReference,
    /// The reference's standard error is over a fifth of the RMSE.
    NoisyReference,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Note::BelowReference => "below the reference's own error",
            Note::NoisyReference => "reference too noisy",
        })
    }
}

impl Errors {
    /// Whether the reference is good enough to judge the error by.
    pub fn note(&self) -> Option<Note> {
        if self.rmse < self.reference_se {
            Some(Note::BelowReference)
        } else {
            (self.reference_se > self.rmse / 5.0).then_some(Note::NoisyReference)
        }
    }
}

/// Channels of counted pixels: image, reference, standard error.
pub(crate) fn errors(values: &[[f64; 3]], flip: f64) -> Errors {
    let mean = |f: &dyn Fn(&[f64; 3]) -> f64| values.iter().map(f).sum::<f64>() / values.len() as f64;
    let square = |[image, reference, s]: &[f64; 3]| (image - reference).powi(2) - s * s;
    let reference = mean(&|[_, r, _]| *r);
    let bias = mean(&|[image, r, _]| image - r);
    let epsilon = (reference / 10.0).powi(2);
    let relative = mean(&|value| square(value) / (value[1] * value[1] + epsilon)).max(0.0);
    let mut distances: Vec<f64> = values.iter().map(|[image, r, _]| (image - r).abs()).collect();
    Errors {
        rmse: mean(&square).max(0.0).sqrt(),
        rel_mse: (epsilon > 0.0).then_some(relative),
        bias,
        bias_rel: (reference != 0.0).then(|| bias / reference),
        p99: quantile(&mut distances, 0.99),
        flip,
        reference_se: mean(&|[_, _, s]| s * s).sqrt(),
    }
}

/// By linear interpolation between sorted values; there is at least one.
fn quantile(values: &mut [f64], share: f64) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let at = share * (values.len() - 1) as f64;
    let (below, above) = (values[at.floor() as usize], values[at.ceil() as usize]);
    below + (above - below) * at.fract()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-12, "{a} is not {b}");
    }

    /// Reference 1 and 3, image 2 and 2: d = 1, −1; ε = (2/10)².
    #[test]
    fn figures_on_paper() {
        let e = errors(&[[2.0, 1.0, 0.0], [2.0, 3.0, 0.0]], 0.25);
        close(e.rmse, 1.0);
        close(e.rel_mse.unwrap_or(0.0), (1.0 / 1.04 + 1.0 / 9.04) / 2.0);
        close(e.bias, 0.0);
        close(e.p99, 1.0);
        close(e.flip, 0.25);
        assert_eq!(e.note(), None);
    }

    #[test]
    fn a_scale_of_ten_per_cent_is_a_bias_of_ten_per_cent_whatever_the_unit() {
        for unit in [1e-6, 1.0, 1e5] {
            let values: Vec<_> = (1..=100).map(|i| f64::from(i) * unit).map(|r| [1.1 * r, r, 0.0]).collect();
            let e = errors(&values, 0.0);
            close(e.bias_rel.unwrap_or(0.0), 0.1);
            close(e.bias / unit, 5.05);
            // Of |d| = 0.1 … 10 in steps of 0.1, the place 98.01 of 0 … 99.
            close(e.p99 / unit, 9.901);
            let relative = |r: f64| (0.1 * r).powi(2) / (r * r + 5.05f64.powi(2));
            close(e.rel_mse.unwrap_or(0.0), (1..=100).map(|i| relative(f64::from(i))).sum::<f64>() / 100.0);
        }
    }

    /// An exact image against a reference off by ±0.3 with standard error 0.3: all of the error is the reference's.
    #[test]
    fn the_references_noise_is_taken_off() {
        let e = errors(&[[1.0, 1.3, 0.3], [1.0, 0.7, 0.3]], 0.0);
        assert!(e.rmse < 1e-8, "{}", e.rmse);
        close(e.reference_se, 0.3);
        assert_eq!(e.note(), Some(Note::BelowReference));
        // The same noise under an error of 1: d = 0.7 and 1.3 from a true 1, so d² − s² = 1 on average.
        let e = errors(&[[2.0, 1.3, 0.3], [2.0, 0.7, 0.3]], 0.0);
        close(e.rmse, 1.0);
        assert_eq!(e.note(), Some(Note::NoisyReference));
        let e = errors(&[[2.0, 1.1, 0.1], [2.0, 0.9, 0.1]], 0.0);
        assert_eq!(e.note(), None);
    }

    #[test]
    fn nothing_is_relative_to_black() {
        let e = errors(&[[0.5, 0.0, 0.0]], 0.0);
        assert_eq!((e.rel_mse, e.bias_rel, e.bias), (None, None, 0.5));
    }
}
