//! What images are held against.

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

use voxlume::Shows;
use voxlume_reference::cache::{Cache, Key};
use voxlume_reference::{Picture, Request, Seen, Tracer};

use super::cell::Subject;
use super::measure::{Measured, screen_pixels};
use super::report::own;
use crate::{Error, Progress};

/// What an image is held against, and what its pixels show.
pub struct Truth {
    pub mean: Vec<[f32; 3]>,
    pub standard_error: Vec<[f32; 3]>,
    pub seen: Vec<Seen>,
}

impl Truth {
    /// An image that was rendered is taken as it is.
    pub fn rendered(measured: &Measured, shows: Shows) -> Truth {
        let pixels = own(shows, &measured.picture).pixels;
        let seen = |surface: &bool| if *surface { Seen::Surface } else { Seen::Nothing };
        Truth {
            standard_error: vec![[0.0; 3]; pixels.len()],
            mean: pixels.into_iter().map(|[r, g, b, _]| [r, g, b]).collect(),
            seen: measured.surface.iter().map(seen).collect(),
        }
    }
}

/// The last one, which cells that follow each other mostly share.
#[derive(Default)]
pub struct Last(Option<(String, Truth)>);

impl Last {
    /// What has that key, made unless it is the last one.
    pub fn or_make(
        &mut self,
        key: &str,
        make: impl FnOnce() -> Result<Truth, Error>,
    ) -> Result<&Truth, Error> {
        let truth = match self.0.take().filter(|(last, _)| last == key) {
            Some((_, truth)) => truth,
            None => make()?,
        };
        Ok(&self.0.insert((key.to_owned(), truth)).1)
    }
}

/// The tracer of the scene at hand, and references kept on disk.
pub struct References {
    cache: Cache,
    tracer: Option<(usize, Tracer)>,
}

impl References {
    /// A cache in a folder.
    pub fn new(folder: &Path) -> References {
        References { cache: Cache::new(folder), tracer: None }
    }

    /// The reference of one of the subjects, for an image of `size` texels over the request's pixels.
    ///
    /// # Errors
    /// What the tracer says; `stop` was raised.
    pub fn get(
        &mut self,
        (index, subject): (usize, &Subject),
        request: &Request,
        size: [u32; 2],
        progress: &mut dyn Progress,
        stop: &AtomicBool,
    ) -> Result<Truth, Error> {
        let failed = |error: voxlume_reference::Error| Error::work(error.to_string());
        let tracer = match self.tracer.take().filter(|(of, _)| *of == index) {
            Some((_, tracer)) => tracer,
            None => Tracer::new(&subject.scene).map_err(failed)?,
        };
        let tracer = &self.tracer.insert((index, tracer)).1;
        let Request { width, height, .. } = *request;
        let key = Key::new(&subject.digest, request);
        let cached = self.cache.get_or_compute(&key, width, height, || {
            let what = format!("reference of {}", subject.label);
            progress.stage(what.clone());
            let progress = Mutex::new(progress);
            let tell = |done| {
                if let Ok(mut progress) = progress.lock() {
                    progress.share(&what, done);
                }
            };
            tracer.render(request, &tell, stop)
        });
        let Picture { mean, standard_error, .. } = cached.map_err(failed)?.picture;
        let seen = tracer.look(&request.camera, width, height).map_err(failed)?;
        let texels: Vec<usize> = screen_pixels([width, height], size).collect();
        Ok(Truth {
            mean: texels.iter().map(|pixel| mean[*pixel]).collect(),
            standard_error: texels.iter().map(|pixel| standard_error[*pixel]).collect(),
            seen: texels.iter().map(|pixel| seen[*pixel]).collect(),
        })
    }
}
