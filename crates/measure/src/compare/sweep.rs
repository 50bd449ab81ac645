//! The sweep: cell after cell.

use std::sync::atomic::{AtomicBool, Ordering};

use voxlume::{Gpu, Plan, Request};
use voxlume_reference::cache::Key;
use voxlume_reference::{Error as TracerError, PixelSampling, Reflection};
use voxlume_report::{Outcome, Results, Row, SCHEMA, csv, page, utc_now};

use super::Sweep;
use super::cell::{Cell, Subject, cells};
use super::folder::{Finished, Folder, Pictures};
use super::measure::measure;
use super::report::judge;
use super::truth::Truths;
use crate::effect::bounces;
use crate::{Error, Progress, describe};

/// What cells need.
struct Run<'a> {
    sweep: &'a Sweep<'a>,
    subjects: Vec<Subject>,
    folder: Folder,
    truths: Truths,
    gpu: Gpu,
    progress: &'a mut dyn Progress,
    stop: &'a AtomicBool,
}

/// What became of a cell.
enum End {
    Finished(Box<Finished>),
    Interrupted,
}

/// Runs all cells and writes the report.
pub fn run(sweep: &Sweep<'_>, progress: &mut dyn Progress, stop: &AtomicBool) -> Result<Results, Error> {
    let (subjects, cells) = cells(sweep)?;
    let folder = Folder::new(&sweep.folder)?;
    let gpu = Gpu::open(sweep.adapter.as_deref())?;
    let device = describe(&gpu.info);
    let truths = Truths::new(&folder.cache());
    let mut run = Run { sweep, subjects, folder, truths, gpu, progress, stop };

    let mut results = Results { schema: SCHEMA, device, rows: Vec::new() };
    let mut pictures = Vec::new();
    for (number, cell) in cells.iter().enumerate() {
        let stem = cell.stem(&run.subjects);
        let place = format!("cell {}/{}: {stem}", number + 1, cells.len());
        let outcome = match if stop.load(Ordering::Relaxed) {
            Ok(End::Interrupted)
        } else {
            run.cell(cell, &stem, &place)
        } {
            Ok(End::Interrupted) => {
                return Err(Error::Interrupted { finished: results.rows.len(), all: cells.len() });
            }
            Ok(End::Finished(finished)) => {
                pictures.push((results.rows.len(), finished.pictures));
                results.rows.push(finished.row);
                continue;
            }
            Err(failure) => Outcome::Failed { fault: failure.to_string() },
        };
        results.rows.push(run.row(cell, outcome));
        // Later cells get a device that works.
        if run.gpu.check().is_err() {
            run.gpu = Gpu::open(sweep.adapter.as_deref())?;
        }
    }
    run.write(&results, &pictures)?;
    Ok(results)
}

impl Run<'_> {
    /// A cell as it lies in the folder, or else made now and put there.
    fn cell(&mut self, cell: &Cell, stem: &str, place: &str) -> Result<End, Error> {
        let plan = self.plan(cell)?;
        let subject = &self.subjects[cell.subject];
        let bounces = bounces(self.sweep.pipeline);
        let request = voxlume_reference::Request {
            camera: subject.camera.clone(),
            width: self.sweep.size[0],
            height: self.sweep.size[1],
            samples: self.sweep.samples,
            seed: 0,
            sampling: PixelSampling::Centre,
            quantity: cell.effect.quantity(self.sweep.pipeline, &plan, &subject.scene, bounces)?,
            reflection: Reflection::Gltf,
        };
        let truth_key = Key::new(&subject.digest, &request).to_hex();
        let key = self.key(&plan, &truth_key);
        if let Some(finished) = self.folder.finished(stem, &key) {
            self.progress.repeated(format!("{place} is there"));
            return Ok(End::Finished(Box::new(finished)));
        }
        let truth = match self.truths.get(&self.subjects, cell.subject, &request, self.progress, self.stop) {
            Ok(truth) => truth,
            Err(TracerError::Cancelled) => return Ok(End::Interrupted),
            Err(error) => return Err(Error::work(error.to_string())),
        };
        self.progress.stage(place.to_owned());
        let measured = measure(&self.gpu, plan, &subject.scene, &subject.camera, self.sweep.repeat)?;
        let judged = judge(cell.effect, &measured, truth)?;
        let outcome = Outcome::Measured {
            passes: measured.passes,
            total_ms: measured.total_ms,
            volume_bytes: measured.volume_bytes,
            out_of_range: measured.out_of_range,
            error: judged.errors,
        };
        let reference = format!("{}-{}-reference-{}", subject.label, cell.effect.name(), &truth_key[..8]);
        let names = [
            format!("{stem}.png"),
            format!("{stem}.exr"),
            format!("{reference}.png"),
            format!("{reference}.exr"),
            format!("{stem}-error.png"),
        ];
        let pictures = Pictures {
            image: names[0].clone(),
            reference: names[2].clone(),
            error: names[4].clone(),
            error_scale: judged.error_scale,
        };
        let finished = Finished { key, row: self.row(cell, outcome), pictures };
        self.folder.finish(stem, &finished, names.into_iter().zip(judged.files).collect())?;
        Ok(End::Finished(Box::new(finished)))
    }

    fn plan(&self, cell: &Cell) -> Result<Plan, Error> {
        let request = Request {
            format: Some(cell.format.clone()),
            encoding: Some(cell.encoding.clone()),
            tracer: self.sweep.tracer.clone(),
            resolution: Some(cell.resolution),
            output: cell.effect.image(self.sweep.pipeline).map(str::to_owned),
            filters_float32: self.gpu.filters_float32(),
            ..Request::image(self.sweep.size[0], self.sweep.size[1])
        };
        let facts = &self.subjects[cell.subject].facts;
        voxlume::plan(self.sweep.pipeline, facts, self.sweep.registry, &request).map_err(Error::from)
    }

    /// Hash of everything that decides a cell: the program, the device, the reference, and the plan with its shaders.
    fn key(&self, plan: &Plan, truth_key: &str) -> String {
        let device = describe(&self.gpu.info);
        let Plan { format, encoding, grid, screen, passes, resources, shaders, .. } = plan;
        let mut hash = blake3::Hasher::new();
        let mut part = |text: &str| {
            hash.update(&(text.len() as u64).to_le_bytes());
            hash.update(text.as_bytes());
        };
        part(concat!("cell 1 of voxlume ", env!("CARGO_PKG_VERSION")));
        part(&format!("{device:?} {}", self.sweep.repeat));
        part(truth_key);
        part(&format!("{format} {encoding:?} {grid:?} {screen:?} {passes:?} {resources:?}"));
        shaders.iter().for_each(|shader| part(&shader.wgsl));
        hash.finalize().to_hex().to_string()
    }

    fn row(&self, cell: &Cell, outcome: Outcome) -> Row {
        Row {
            scene: self.subjects[cell.subject].label.clone(),
            effect: cell.effect.name().to_owned(),
            format: cell.format.clone(),
            encoding: cell.encoding.clone(),
            resolution: cell.resolution,
            width: self.sweep.size[0],
            height: self.sweep.size[1],
            outcome,
        }
    }

    fn write(&mut self, results: &Results, pictures: &[(usize, Pictures)]) -> Result<(), Error> {
        self.progress.stage("writing the report".into());
        let mut strips = Vec::new();
        for (row, pictures) in pictures {
            strips.push(self.folder.strip(*row, pictures)?);
        }
        let [width, height] = self.sweep.size;
        let subtitle = format!(
            "{width} × {height} pixels; reference of {} samples a pixel; medians of {} frames",
            self.sweep.samples, self.sweep.repeat
        );
        let json = results.to_json().map_err(|error| Error::work(error.to_string()))?;
        let html = page(results, &strips, &utc_now(), &subtitle);
        self.folder.write(vec![("results.json", json), ("results.csv", csv(results)), ("report.html", html)])
    }
}
