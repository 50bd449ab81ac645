//! Pictures for the eye.

use std::io::Cursor;

use image::codecs::jpeg::JpegEncoder;
use image::{ImageFormat, RgbImage};

use crate::comparison::Comparison;

/// Why there is no PNG.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The bytes are not three for each pixel.
    #[error("{bytes} bytes are no picture of {width}x{height} pixels")]
    Size {
        /// How many there are.
        bytes: usize,
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The encoder failed.
    #[error("cannot encode the picture: {0}")]
    Encode(#[from] image::ImageError),
}

/// A PNG file of 8-bit sRGB, three bytes a pixel.
///
/// # Errors
/// Bytes of another number.
pub fn png(width: u32, height: u32, rgb: Vec<u8>) -> Result<Vec<u8>, PictureError> {
    let bytes = rgb.len();
    let image = RgbImage::from_raw(width, height, rgb).ok_or(PictureError::Size { bytes, width, height })?;
    let mut file = Cursor::new(Vec::new());
    image.write_to(&mut file, ImageFormat::Png)?;
    Ok(file.into_inner())
}

/// The same picture as a JPEG file, a fraction as large, for where thousandths don't matter.
pub(crate) fn jpeg(png: &[u8]) -> Result<Vec<u8>, PictureError> {
    let image = image::load_from_memory_with_format(png, ImageFormat::Png)?.into_rgb8();
    let mut file = Vec::new();
    image.write_with_encoder(JpegEncoder::new_with_quality(&mut file, JPEG_QUALITY))?;
    Ok(file)
}

/// Of 100.
const JPEG_QUALITY: u8 = 75;

/// White where image and reference agree, red where the image is too bright, blue where too dark, full at `scale`;
/// grey where a pixel doesn't count. Judged by the mean of the channels. Three bytes a pixel.
pub fn signed_error(comparison: &Comparison<'_>, scale: f64) -> Vec<u8> {
    let mean = |pixel: &[f32; 3]| pixel.iter().map(|value| f64::from(*value)).sum::<f64>() / 3.0;
    let pixels = comparison.image.iter().zip(comparison.reference).zip(comparison.counted);
    let colors = pixels.flat_map(|((image, reference), counted)| {
        if !counted {
            return [200; 3];
        }
        let share = ((mean(image) - mean(reference)) / scale.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0);
        let full = if share > 0.0 { [178.0, 24.0, 43.0] } else { [33.0, 102.0, 172.0] };
        full.map(|c: f64| (255.0 + (c - 255.0) * share.abs()).round() as u8)
    });
    colors.collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn too_bright_is_red_and_too_dark_is_blue() {
        let comparison = Comparison {
            width: 5,
            height: 1,
            image: &[[2.0; 3], [0.0; 3], [1.0; 3], [1.25; 3], [9.0; 3]],
            reference: &[[1.0; 3]; 5],
            standard_error: &[[0.0; 3]; 5],
            counted: &[true, true, true, true, false],
        };
        let expected = [[178, 24, 43], [33, 102, 172], [255; 3], [217, 140, 149], [200; 3]].concat();
        assert_eq!(signed_error(&comparison, 0.5), expected);
    }

    #[test]
    fn png_keeps_the_bytes() {
        let file = png(2, 1, vec![1, 2, 3, 4, 5, 6]).unwrap();
        let read = image::load_from_memory(&file).unwrap().into_rgb8();
        assert_eq!((read.dimensions(), read.into_raw()), ((2, 1), vec![1, 2, 3, 4, 5, 6]));
        let message = png(2, 2, vec![0; 6]).unwrap_err().to_string();
        assert_eq!(message, "6 bytes are no picture of 2x2 pixels");
    }
}
