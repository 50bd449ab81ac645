//! Finished cells on disk.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use voxlume::Fault;
use voxlume_report::{Bound, Results, Row, Strip, csv, overview_plot, page, utc_now};

use crate::Error;
use crate::outfile::{self, OutFile};

/// The folder of a sweep: `cells`, `images`, `cache`, and the report.
pub struct Folder(PathBuf);

/// A finished cell. Its pictures are in `images`.
#[derive(Serialize, Deserialize)]
pub struct Finished {
    /// Hash of everything that decides the cell.
    pub key: String,
    pub row: Row,
    pub pictures: Pictures,
}

/// Names of PNG files.
#[derive(Serialize, Deserialize)]
pub struct Pictures {
    pub image: String,
    pub reference: String,
    pub error: String,
    /// The error whose colour is full.
    pub error_scale: f64,
}

impl Folder {
    /// Makes what is missing of the folder.
    pub fn new(path: &Path) -> Result<Folder, Error> {
        for part in ["cells", "images"] {
            let folder = path.join(part);
            let cannot =
                |error| Fault::new(format!("cannot make the folder `{}`: {error}", folder.display()));
            std::fs::create_dir_all(&folder).map_err(cannot)?;
        }
        Ok(Folder(path.to_path_buf()))
    }

    /// Where references are kept.
    pub fn cache(&self) -> PathBuf {
        self.0.join("cache")
    }

    /// The cell, if it was finished under the same key and its pictures are there.
    pub fn finished(&self, stem: &str, key: &str) -> Option<Finished> {
        let text = std::fs::read_to_string(self.0.join("cells").join(format!("{stem}.json"))).ok()?;
        let finished: Finished =
            serde_json::from_str(&text).ok().filter(|cell: &Finished| cell.key == key)?;
        let Pictures { image, reference, error, error_scale: _ } = &finished.pictures;
        let there = [image, reference, error].into_iter().all(|name| self.image(name).is_file());
        there.then_some(finished)
    }

    /// Keeps a cell, after its pictures.
    pub fn finish(
        &self,
        stem: &str,
        finished: &Finished,
        images: Vec<(String, Vec<u8>)>,
    ) -> Result<(), Error> {
        let mut files = Vec::new();
        for (name, bytes) in images {
            files.push((OutFile::new(&self.image(&name))?, bytes));
        }
        outfile::write(&files)?;
        let text = serde_json::to_vec_pretty(finished).map_err(|error| Error::work(error.to_string()))?;
        let cell = self.0.join("cells").join(format!("{stem}.json"));
        outfile::write(&[(OutFile::new(&cell)?, text)])
    }

    /// Writes the report's files, all or none. `pictures` are those of a row each.
    pub fn report(
        &self,
        results: &Results,
        pictures: &[(usize, Pictures)],
        bounds: &[Bound],
        subtitle: &str,
    ) -> Result<(), Error> {
        let strips: Vec<Strip> =
            pictures.iter().map(|(row, pictures)| self.strip(*row, pictures)).collect::<Result<_, _>>()?;
        let json = results.to_json().map_err(|error| Error::work(error.to_string()))?;
        let html = page(results, &strips, bounds, &utc_now(), subtitle);
        let files = [("results.json", json), ("results.csv", csv(results)), ("report.html", html)];
        let plot = overview_plot(results).map(|svg| ("overview.svg", svg));
        let out = files
            .into_iter()
            .chain(plot)
            .map(|(name, text)| Ok((OutFile::new(&self.0.join(name))?, text.into_bytes())));
        outfile::write(&out.collect::<Result<Vec<_>, Error>>()?)
    }

    /// A finished cell's pictures, for the page.
    fn strip(&self, row: usize, pictures: &Pictures) -> Result<Strip, Error> {
        let read = |name: &str| {
            let path = self.image(name);
            std::fs::read(&path)
                .map_err(|error| Error::work(format!("cannot read `{}`: {error}", path.display())))
        };
        let Pictures { image, reference, error, error_scale } = pictures;
        Ok(Strip {
            row,
            image: read(image)?,
            reference: read(reference)?,
            error: read(error)?,
            error_scale: *error_scale,
        })
    }

    fn image(&self, name: &str) -> PathBuf {
        self.0.join("images").join(name)
    }
}
