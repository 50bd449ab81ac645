//! Pictures as files.

use std::io::Cursor;
use std::path::Path;

use exr::prelude::{Encoding, Image, Layer, LayerAttributes, SpecificChannels, WritableImage};
use image::{ImageFormat, RgbImage};
use voxlume::{Fault, Picture, Shows, one_of};

use crate::Error;
use crate::tone::{reinhard, srgb};

/// A kind of picture file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// For the eye, 8 bits.
    Png,
    /// As computed, 32-bit float.
    Exr,
}

impl Kind {
    /// By the path's extension.
    pub fn of(path: &Path) -> Result<Kind, Fault> {
        match path.extension().unwrap_or_default().to_string_lossy().to_lowercase().as_str() {
            "png" => Ok(Kind::Png),
            "exr" => Ok(Kind::Exr),
            _ => {
                let fault = Fault::new(format!("`{}` is no picture by its extension", path.display()));
                Err(fault.note(one_of(["png", "exr"])))
            }
        }
    }

    /// The whole file's bytes. `scale` multiplies light in a PNG.
    pub fn encode(self, picture: &Picture, shows: Shows, scale: f32) -> Result<Vec<u8>, Error> {
        let mut bytes = Cursor::new(Vec::new());
        match self {
            Kind::Png => {
                let image = RgbImage::from_raw(picture.width, picture.height, shown(picture, shows, scale))
                    .ok_or_else(|| Error::work("a picture of another size than its pixels"))?;
                image.write_to(&mut bytes, ImageFormat::Png).map_err(failed)?;
            }
            Kind::Exr => {
                let width = picture.width as usize;
                let channels = SpecificChannels::rgba(|at: exr::math::Vec2<usize>| {
                    let [r, g, b, a] = picture.pixels[at.y() * width + at.x()];
                    (r, g, b, a)
                });
                let attributes =
                    LayerAttributes { software_name: Some("voxlume".into()), ..LayerAttributes::default() };
                let layer = Layer::new(
                    (width, picture.height as usize),
                    attributes,
                    Encoding::SMALL_LOSSLESS,
                    channels,
                );
                Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).map_err(failed)?;
            }
        }
        Ok(bytes.into_inner())
    }
}

fn failed(error: impl std::fmt::Display) -> Error {
    Error::work(format!("cannot encode the picture: {error}"))
}

/// A picture for the eye, three bytes a pixel, as in a PNG.
pub fn shown(picture: &Picture, shows: Shows, scale: f32) -> Vec<u8> {
    picture.pixels.iter().flat_map(|[r, g, b, _]| visible(shows, [*r, *g, *b], scale)).collect()
}

/// A value for the eye. `scale` multiplies light.
pub fn visible(shows: Shows, color: [f32; 3], scale: f32) -> [u8; 3] {
    let shown = match shows {
        Shows::Normal => color.map(|c| c * 0.5 + 0.5),
        Shows::Share => color,
        Shows::Albedo => color.map(|c| srgb(c.clamp(0.0, 1.0))),
        Shows::Light => reinhard(color.map(|c| c * scale)).map(srgb),
    };
    // A conversion to an integer saturates, and makes 0 of NaN.
    shown.map(|c| (c * 255.0).round() as u8)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use exr::prelude::{ReadChannels, ReadLayers};

    use super::*;

    #[test]
    fn values_are_shown_as_what_they_are() {
        let pixel = [0.5, -1.0, 2.0];
        assert_eq!(visible(Shows::Normal, pixel, 4.0), [191, 0, 255]);
        assert_eq!(visible(Shows::Share, pixel, 4.0), [128, 0, 255]);
        assert_eq!(visible(Shows::Albedo, pixel, 4.0), [188, 0, 255]);
        assert_eq!(visible(Shows::Light, [0.25; 3], 2.0), visible(Shows::Light, [0.5; 3], 1.0));
    }

    #[test]
    fn exr_keeps_every_bit() {
        let pixels = vec![[1e-6, 65504.0, -0.25, 0.5], [0.1, 0.2, 0.3, 1.0]];
        let picture = Picture { width: 2, height: 1, pixels: pixels.clone() };
        let bytes = Kind::Exr.encode(&picture, Shows::Light, 8.0).unwrap();
        let read = exr::prelude::read()
            .no_deep_data()
            .largest_resolution_level()
            .rgba_channels(
                |_, _| Vec::new(),
                |read: &mut Vec<[f32; 4]>, _, (r, g, b, a)| read.push([r, g, b, a]),
            )
            .first_valid_layer()
            .all_attributes()
            .from_buffered(Cursor::new(bytes))
            .unwrap();
        assert_eq!(read.layer_data.channel_data.pixels, pixels);
    }
}
