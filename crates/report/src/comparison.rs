//! An image beside its reference.

use crate::flip::flip;
use crate::metric::{Errors, errors};

/// An image and its reference: `width × height` linear pixels each, row-major from the top left.
#[derive(Clone, Copy, Debug)]
pub struct Comparison<'a> {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The image.
    pub image: &'a [[f32; 3]],
    /// What it should be.
    pub reference: &'a [[f32; 3]],
    /// The standard error of each of the reference's values.
    pub standard_error: &'a [[f32; 3]],
    /// The pixels that count.
    pub counted: &'a [bool],
}

/// A comparison as a screen shows it: 8-bit sRGB, three bytes a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    /// The image.
    pub image: &'a [u8],
    /// The reference.
    pub reference: &'a [u8],
}

/// Why there are no figures.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ComparisonError {
    /// A part is of another length.
    #[error("{what} has {given} values, not the {wanted} of {width}x{height} pixels")]
    Size {
        /// Which part.
        what: &'static str,
        /// How many it has.
        given: usize,
        /// How many it should have.
        wanted: u64,
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// Every pixel is left out.
    #[error("no pixel counts: neither image nor reference has a surface in the same place")]
    Nothing,
    /// A NaN or an infinity.
    #[error("{what} is not finite at pixel ({x}, {y})")]
    NotFinite {
        /// The image or the reference.
        what: &'static str,
        /// Column.
        x: u32,
        /// Row.
        y: u32,
    },
}

impl Comparison<'_> {
    /// The figures. `shown` is for FLIP; pixels that don't count take the reference's colour there.
    ///
    /// # Errors
    /// Parts of different sizes, nothing to compare, a value that is not finite.
    pub fn errors(&self, shown: &Shown<'_>) -> Result<Errors, ComparisonError> {
        self.check(shown)?;
        let mut values = Vec::new();
        for index in (0..self.counted.len()).filter(|index| self.counted[*index]) {
            for channel in 0..3 {
                let parts = [self.image, self.reference, self.standard_error];
                let value = parts.map(|part| f64::from(part[index][channel]));
                if let Some(part) = value.iter().position(|v| !v.is_finite()) {
                    let what = if part == 0 { "the image" } else { "the reference" };
                    let (x, y) = (index as u32 % self.width, index as u32 / self.width);
                    return Err(ComparisonError::NotFinite { what, x, y });
                }
                values.push(value);
            }
        }
        if values.is_empty() {
            return Err(ComparisonError::Nothing);
        }
        Ok(errors(&values, flip(self.width, self.height, self.counted, shown)))
    }

    fn check(&self, shown: &Shown<'_>) -> Result<(), ComparisonError> {
        let (width, height) = (self.width, self.height);
        let pixels = u64::from(width) * u64::from(height);
        let lengths = [
            ("the image", self.image.len(), pixels),
            ("the reference", self.reference.len(), pixels),
            ("the standard error", self.standard_error.len(), pixels),
            ("the mask", self.counted.len(), pixels),
            ("the shown image", shown.image.len(), 3 * pixels),
            ("the shown reference", shown.reference.len(), 3 * pixels),
        ];
        match lengths.into_iter().find(|(_, given, wanted)| *given as u64 != *wanted) {
            Some((what, given, wanted)) => Err(ComparisonError::Size { what, given, wanted, width, height }),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    const BYTES: Shown<'_> = Shown { image: &[90; 12], reference: &[90; 12] };

    fn comparison<'a>(image: &'a [[f32; 3]], counted: &'a [bool]) -> Comparison<'a> {
        let reference = &[[1.0; 3]; 4];
        Comparison { width: 2, height: 2, image, reference, standard_error: &[[0.0; 3]; 4], counted }
    }

    #[test]
    fn only_counted_pixels_count() {
        let image = [[1.5; 3], [f32::NAN; 3], [1.0; 3], [9.0; 3]];
        let e = comparison(&image, &[true, false, true, false]).errors(&BYTES).unwrap();
        assert_eq!((e.bias, e.rmse, e.flip), (0.25, 0.125f64.sqrt(), 0.0));
    }

    #[test]
    fn faults() {
        let message = |c: Comparison<'_>| c.errors(&BYTES).unwrap_err().to_string();
        let image = [[1.0; 3], [1.0; 3], [1.0; 3], [1.0, f32::INFINITY, 1.0]];
        assert_eq!(message(comparison(&image, &[true; 4])), "the image is not finite at pixel (1, 1)");
        assert_eq!(
            message(comparison(&image, &[false; 4])),
            "no pixel counts: neither image nor reference has a surface in the same place"
        );
        assert_eq!(
            message(comparison(&image[..3], &[true; 4])),
            "the image has 3 values, not the 4 of 2x2 pixels"
        );
    }
}
