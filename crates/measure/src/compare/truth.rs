//! References, kept on disk.

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

use voxlume_reference::cache::{Cache, Key};
use voxlume_reference::{Error, Picture, Request, Seen, Tracer};

use super::cell::Subject;
use crate::Progress;

/// A reference, and what its pixels show.
pub struct Truth {
    pub picture: Picture,
    pub seen: Vec<Seen>,
}

/// The tracer of the scene at hand, and the cache.
pub struct Truths {
    cache: Cache,
    tracer: Option<(usize, Tracer)>,
    /// The last one, which cells that follow each other mostly share.
    last: Option<(Key, Truth)>,
}

impl Truths {
    /// A cache in a folder.
    pub fn new(folder: &Path) -> Truths {
        Truths { cache: Cache::new(folder), tracer: None, last: None }
    }

    /// The reference of one of the subjects.
    ///
    /// # Errors
    /// What the tracer says, [`Error::Cancelled`] among it.
    pub fn get(
        &mut self,
        subjects: &[Subject],
        subject: usize,
        request: &Request,
        progress: &mut dyn Progress,
        stop: &AtomicBool,
    ) -> Result<&Truth, Error> {
        let key = Key::new(&subjects[subject].digest, request);
        let truth = match self.last.take().filter(|(last, _)| *last == key) {
            Some((_, truth)) => truth,
            None => self.fetch(subjects, subject, request, &key, progress, stop)?,
        };
        Ok(&self.last.insert((key, truth)).1)
    }

    fn fetch(
        &mut self,
        subjects: &[Subject],
        subject: usize,
        request: &Request,
        key: &Key,
        progress: &mut dyn Progress,
        stop: &AtomicBool,
    ) -> Result<Truth, Error> {
        let tracer = match self.tracer.take().filter(|(of, _)| *of == subject) {
            Some((_, tracer)) => tracer,
            None => Tracer::new(&subjects[subject].scene)?,
        };
        let tracer = &self.tracer.insert((subject, tracer)).1;
        let Request { width, height, .. } = *request;
        let cached = self.cache.get_or_compute(key, width, height, || {
            let what = format!("reference of {}", subjects[subject].label);
            progress.stage(what.clone());
            let progress = Mutex::new(progress);
            let tell = |done| {
                if let Ok(mut progress) = progress.lock() {
                    progress.share(&what, done);
                }
            };
            tracer.render(request, &tell, stop)
        })?;
        let seen = tracer.look(&request.camera, width, height)?;
        Ok(Truth { picture: cached.picture, seen })
    }
}
