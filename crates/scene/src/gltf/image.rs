//! Images, decoded in parallel.

use std::borrow::Cow;
use std::io::Cursor;
use std::path::Path;

use gltf::json::{Index, Root, texture};
use image::{ImageFormat, ImageReader, Limits};
use rayon::prelude::*;
use voxlume_fault::{Fault, Faults};

use super::{at, source};
use crate::Texture;
use crate::limit::{Budget, MEMORY_LIMIT};

/// The textures that materials ask for: an image as colour or as data, each once.
#[derive(Default)]
pub(super) struct Wanted(Vec<Use>);

struct Use {
    image: usize,
    srgb: bool,
    name: String,
}

impl Wanted {
    /// The index that the texture will have in the scene; `None` if it has no image.
    pub(super) fn index(
        &mut self,
        root: &Root,
        texture: Index<texture::Texture>,
        srgb: bool,
    ) -> Option<usize> {
        let json = &root.textures[texture.value()];
        let image = json.source.value();
        let of_image = root.images.get(image)?;
        if let Some(known) = self.0.iter().position(|u| (u.image, u.srgb) == (image, srgb)) {
            return Some(known);
        }
        let name = json.name.clone().or_else(|| of_image.name.clone());
        self.0.push(Use { image, srgb, name: name.unwrap_or_else(|| format!("texture {}", self.0.len())) });
        Some(self.0.len() - 1)
    }

    /// Decodes them.
    pub(super) fn decode(
        self,
        root: &Root,
        buffers: &[Cow<'_, [u8]>],
        folder: &Path,
        budget: &mut Budget,
    ) -> Result<Vec<Texture>, Faults> {
        let mut faults = Faults::default();
        let mut files = Vec::new();
        for wanted in self.0 {
            let file = bytes(root, buffers, folder, wanted.image).and_then(|bytes| {
                let (width, height) = header(&bytes, wanted.image)?;
                budget.take(u64::from(width) * u64::from(height), 4)?;
                Ok((wanted, bytes))
            });
            files.extend(faults.gather(file));
        }
        let files = faults.into_result(files)?;

        let decoded: Vec<Result<Texture, Fault>> = files.into_par_iter().map(decode).collect();
        let mut faults = Faults::default();
        let textures = decoded.into_iter().filter_map(|texture| faults.gather(texture)).collect();
        faults.into_result(textures)
    }
}

fn bytes<'a>(
    root: &'a Root,
    buffers: &'a [Cow<'_, [u8]>],
    folder: &Path,
    index: usize,
) -> Result<Cow<'a, [u8]>, Fault> {
    let json = &root.images[index];
    match (&json.uri, json.buffer_view) {
        (Some(uri), _) => {
            source::resolve(uri, folder).map(Cow::Owned).map_err(|e| at(format!("images[{index}].uri"), e))
        }
        (None, Some(view)) => source::view(root, buffers, view).map(|(_, bytes)| Cow::Borrowed(bytes)),
        (None, None) => Err(at(format!("images[{index}]"), "neither a uri nor a bufferView")),
    }
}

fn reader(bytes: &[u8], index: usize) -> Result<ImageReader<Cursor<&[u8]>>, Fault> {
    let unknown = |what| at(format!("images[{index}]"), format!("{what}: only PNG and JPEG are read"));
    let mut reader =
        ImageReader::new(Cursor::new(bytes)).with_guessed_format().map_err(|_| unknown("not an image"))?;
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(MEMORY_LIMIT);
    reader.limits(limits);
    match reader.format() {
        Some(ImageFormat::Png | ImageFormat::Jpeg) => Ok(reader),
        Some(ImageFormat::WebP) => Err(unknown("a WebP image")),
        Some(ImageFormat::Hdr) => Err(unknown("a Radiance HDR image")),
        Some(ImageFormat::Dds) => Err(unknown("a DDS texture")),
        _ => Err(unknown(source::kind(bytes).unwrap_or("not an image"))),
    }
}

fn header(bytes: &[u8], index: usize) -> Result<(u32, u32), Fault> {
    reader(bytes, index)?.into_dimensions().map_err(|error| broken(index, error))
}

fn decode((Use { image, srgb, name }, bytes): (Use, Cow<'_, [u8]>)) -> Result<Texture, Fault> {
    let decoded = reader(&bytes, image)?.decode().map_err(|error| broken(image, error))?.into_rgba8();
    let (width, height) = decoded.dimensions();
    if width == 0 || height == 0 {
        return Err(at(format!("images[{image}]"), "it has no texels"));
    }
    Ok(Texture { name, width, height, rgba: decoded.into_raw(), srgb })
}

fn broken(index: usize, error: image::ImageError) -> Fault {
    at(format!("images[{index}]"), format!("cannot be decoded: {error}"))
}
