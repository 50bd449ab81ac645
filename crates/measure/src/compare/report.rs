//! An image held against its reference, with the pictures that show it.

use voxlume::{Fault, Picture, Reference, Shows};
use voxlume_reference::Seen;
use voxlume_report::{Comparison, Errors, Shown, png, signed_error};

use super::measure::Measured;
use super::truth::Truth;
use crate::Error;
use crate::effect::Effect;
use crate::picture::{Kind, shown};

/// Figures and pictures of a cell.
pub struct Judged {
    pub errors: Errors,
    /// PNG and EXR of the image, PNG and EXR of the reference, PNG of the error.
    pub files: [Vec<u8>; 5],
    /// The error whose colour is full.
    pub error_scale: f64,
}

/// Compares the pixels in which both show a surface; emitters only in the whole image, or where all that is seen emits.
pub fn judge(effect: &Effect<'_>, measured: &Measured, truth: &Truth) -> Result<Judged, Error> {
    let image = own(effect.shows, &measured.picture);
    let Picture { width, height, .. } = image;
    let reference =
        Picture { width, height, pixels: truth.mean.iter().map(|[r, g, b]| [*r, *g, *b, 1.0]).collect() };
    // What an emitter receives is rarely seen, unless the scene has nothing else to look at.
    let emitters = effect.reference == Some(Reference::Final) || !truth.seen.contains(&Seen::Surface);
    let counts = |(seen, surface): (&Seen, &bool)| {
        *surface && (*seen == Seen::Surface || (*seen == Seen::Emitter && emitters))
    };
    let counted: Vec<bool> = truth.seen.iter().zip(&measured.surface).map(counts).collect();
    let rgb: Vec<[f32; 3]> = image.pixels.iter().map(|[r, g, b, _]| [*r, *g, *b]).collect();
    let comparison = Comparison {
        width,
        height,
        image: &rgb,
        reference: &truth.mean,
        standard_error: &truth.standard_error,
        counted: &counted,
    };
    let (mut image_rgb, reference_rgb) =
        (shown(&image, effect.shows, 1.0), shown(&reference, effect.shows, 1.0));
    // Effects leave black where there is no surface; the eye had better not take that for an error.
    for (index, _) in
        truth.seen.iter().enumerate().filter(|(i, seen)| **seen == Seen::Nothing && !measured.surface[*i])
    {
        image_rgb[3 * index..3 * index + 3].copy_from_slice(&reference_rgb[3 * index..3 * index + 3]);
    }
    let errors = comparison
        .errors(&Shown { image: &image_rgb, reference: &reference_rgb })
        .map_err(|error| Error::Work(Fault::new(error.to_string())))?;

    // Half of the reference's mean is full colour, so that cells can be compared by eye.
    let values = reference.pixels.iter().zip(&counted).filter(|(_, counts)| **counts);
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), (pixel, _)| {
        (sum + pixel[..3].iter().map(|value| f64::from(value.abs())).sum::<f64>() / 3.0, count + 1.0)
    });
    let error_scale = 0.5 * sum / count;
    let encoded = |rgb| png(width, height, rgb).map_err(|error| Error::work(error.to_string()));
    let files = [
        encoded(image_rgb)?,
        Kind::Exr.encode(&image, effect.shows, 1.0)?,
        encoded(reference_rgb)?,
        Kind::Exr.encode(&reference, effect.shows, 1.0)?,
        encoded(signed_error(&comparison, error_scale))?,
    ];
    Ok(Judged { errors, files, error_scale })
}

/// The image's own values in all three channels: a share's other channels may be those of other lights.
pub fn own(shows: Shows, picture: &Picture) -> Picture {
    let mut picture = picture.clone();
    if shows == Shows::Share {
        picture.pixels.iter_mut().for_each(|[r, g, b, _]| (*g, *b) = (*r, *r));
    }
    picture
}
