//! Pictures kept on disk, each under the hash of everything that decides it.
//!
//! A file `<key>.reference` holds, little-endian: the 8 bytes `VXLREF01`; the [`Key`], 32 bytes; width
//! and height, u32; then `width × height` times three f32 of means, as many of standard errors; and
//! the BLAKE3 hash of all of that, 32 bytes. A file that differs in its length, key, size or hash is
//! as good as none: its picture is computed again and the file replaced.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub use crate::digest::{Key, SceneDigest};
use crate::{Error, Picture};

const MAGIC: &[u8; 8] = b"VXLREF01";
const HEADER: usize = 48;
const CHECKSUM: usize = 32;
/// Mean and standard error, three channels of f32 each.
const PIXEL: usize = 24;

/// A folder of pictures.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
}

/// A picture, and where it came from.
#[derive(Debug)]
pub struct Cached {
    /// The picture.
    pub picture: Picture,
    /// Whether it was read from the folder.
    pub hit: bool,
    /// Why a picture just computed could not be kept, if so.
    pub store_error: Option<io::Error>,
}

impl Cache {
    /// The cache in a folder, which is made when the first picture is stored.
    pub fn new(folder: impl AsRef<Path>) -> Self {
        Cache { folder: folder.as_ref().to_owned() }
    }

    /// The picture under `key`, of `width` by `height` pixels, or what `compute` gives, which is then
    /// kept. A folder that can't be written to costs the keeping, not the picture.
    ///
    /// # Errors
    /// Those of `compute`.
    pub fn get_or_compute(
        &self,
        key: &Key,
        width: u32,
        height: u32,
        compute: impl FnOnce() -> Result<Picture, Error>,
    ) -> Result<Cached, Error> {
        if let Some(picture) = self.load(key, width, height) {
            return Ok(Cached { picture, hit: true, store_error: None });
        }
        let picture = compute()?;
        let store_error = self.store(key, &picture).err();
        Ok(Cached { picture, hit: false, store_error })
    }

    /// The intact picture of that size under `key`, if there is one.
    pub fn load(&self, key: &Key, width: u32, height: u32) -> Option<Picture> {
        let path = self.path(key);
        let pixels = usize::try_from(u64::from(width) * u64::from(height)).ok()?;
        let length = HEADER + pixels.checked_mul(PIXEL)? + CHECKSUM;
        // Looked at before reading, so that a file of absurd length is not read at all.
        if std::fs::metadata(&path).ok()?.len() != length as u64 {
            return None;
        }
        let file = std::fs::read(&path).ok().filter(|file| file.len() == length)?;
        let (body, checksum) = file.split_at(length - CHECKSUM);
        let (head, payload) = body.split_at(HEADER);
        if head != header(key, width, height) || blake3::hash(body).as_bytes() != checksum {
            return None;
        }
        let (mean, standard_error) = payload.split_at(payload.len() / 2);
        Some(Picture { width, height, mean: pixels_from(mean), standard_error: pixels_from(standard_error) })
    }

    /// Keeps a picture: written to a temporary file in the folder, then renamed.
    ///
    /// # Errors
    /// If the folder can't be made or written to.
    pub fn store(&self, key: &Key, picture: &Picture) -> io::Result<()> {
        let mut body = header(key, picture.width, picture.height);
        for value in picture.mean.iter().chain(&picture.standard_error).flatten() {
            body.extend(value.to_le_bytes());
        }
        let checksum = blake3::hash(&body);
        std::fs::create_dir_all(&self.folder)?;
        let mut file = tempfile::NamedTempFile::new_in(&self.folder)?;
        file.write_all(&body)?;
        file.write_all(checksum.as_bytes())?;
        file.persist(self.path(key))?;
        Ok(())
    }

    /// The file of a key.
    pub fn path(&self, key: &Key) -> PathBuf {
        self.folder.join(format!("{}.reference", key.to_hex()))
    }
}

fn header(key: &Key, width: u32, height: u32) -> Vec<u8> {
    let mut header = MAGIC.to_vec();
    header.extend(key.0);
    header.extend(width.to_le_bytes());
    header.extend(height.to_le_bytes());
    header
}

fn pixels_from(bytes: &[u8]) -> Vec<[f32; 3]> {
    let (floats, _) = bytes.as_chunks::<4>();
    let (pixels, _) = floats.as_chunks::<3>();
    pixels.iter().map(|pixel| pixel.map(f32::from_le_bytes)).collect()
}
