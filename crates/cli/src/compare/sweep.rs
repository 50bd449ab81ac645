//! The sweep: cell after cell.

use std::path::Path;

use voxlume::{Fault, Gpu, Pipeline, Plan, Request};
use voxlume_reference::cache::Key;
use voxlume_reference::{Error as TracerError, PixelSampling, Reflection};
use voxlume_report::{Outcome, Results, Row, SCHEMA, against, csv, page, table, utc_now};

use super::Args;
use super::cell::{Cell, Subject, cells};
use super::folder::{Finished, Folder, Pictures};
use super::measure::measure;
use super::report::judge;
use super::truth::Truths;
use crate::effect::bounces;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::{Registry, devices, interrupt, pipeline};

/// What cells need.
struct Sweep<'a> {
    args: &'a Args,
    registry: &'a Registry,
    pipeline: Pipeline,
    subjects: Vec<Subject>,
    folder: Folder,
    truths: Truths,
    gpu: Gpu,
    progress: Progress,
}

/// What became of a cell.
enum End {
    Finished(Box<Finished>),
    Interrupted,
}

/// Runs all cells and writes the report.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    interrupt::wish();
    let pipeline = pipeline::load(&args.pipeline)?;
    let mut progress = Progress::new();
    progress.stage("loading".into());
    let baseline = args.baseline.as_deref().map(baseline).transpose()?;
    let (subjects, cells) = cells(args, registry, &pipeline)?;
    let folder = Folder::new(&args.out)?;
    let gpu = Gpu::open(args.adapter.as_deref())?;
    let device = devices::describe(&gpu.info);
    let truths = Truths::new(&folder.cache());
    let mut sweep = Sweep { args, registry, pipeline, subjects, folder, truths, gpu, progress };

    let mut results = Results { schema: SCHEMA, device, rows: Vec::new() };
    let mut pictures = Vec::new();
    for (number, cell) in cells.iter().enumerate() {
        let stem = cell.stem(&sweep.subjects);
        let place = format!("cell {}/{}: {stem}", number + 1, cells.len());
        let outcome = match if interrupt::wished() {
            Ok(End::Interrupted)
        } else {
            sweep.cell(cell, &stem, &place)
        } {
            Ok(End::Interrupted) => {
                let (finished, all) = (results.rows.len(), cells.len());
                let out = args.out.display();
                return Err(Failure::work(format!(
                    "interrupted: {finished} of {all} cells are finished and kept in `{out}`; the same command goes on from there"
                )));
            }
            Ok(End::Finished(finished)) => {
                pictures.push((results.rows.len(), finished.pictures));
                results.rows.push(finished.row);
                continue;
            }
            Err(failure) => Outcome::Failed { fault: failure.to_string() },
        };
        results.rows.push(sweep.row(cell, outcome));
        // Later cells get a device that works.
        if sweep.gpu.check().is_err() {
            sweep.gpu = Gpu::open(args.adapter.as_deref())?;
        }
    }
    sweep.write(&results, &pictures)?;
    drop(sweep);
    crate::print(&table(&results))?;
    if let Some(baseline) = baseline {
        crate::print(&format!("\nsince the baseline:\n{}", against(&results, &baseline)))?;
    }
    let failed = results.rows.iter().filter(|row| matches!(row.outcome, Outcome::Failed { .. })).count();
    match failed {
        0 => Ok(()),
        _ => Err(Failure::work(format!(
            "{failed} of {} cells failed; results.json says why",
            results.rows.len()
        ))),
    }
}

/// Reads the results of another time.
fn baseline(path: &Path) -> Result<Results, Fault> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| Fault::new(format!("cannot read `{}`: {error}", path.display())))?;
    Results::parse(&text).map_err(|error| Fault::new(format!("`{}`: {error}", path.display())))
}

impl Sweep<'_> {
    /// A cell as it lies in the folder, or else made now and put there.
    fn cell(&mut self, cell: &Cell, stem: &str, place: &str) -> Result<End, Failure> {
        let plan = self.plan(cell)?;
        let subject = &self.subjects[cell.subject];
        let bounces = bounces(&self.pipeline);
        let request = voxlume_reference::Request {
            camera: subject.camera.clone(),
            width: self.args.size[0],
            height: self.args.size[1],
            samples: self.args.spp,
            seed: 0,
            sampling: PixelSampling::Centre,
            quantity: cell.effect.quantity(&self.pipeline, &plan, &subject.scene, bounces)?,
            reflection: Reflection::Gltf,
        };
        let truth_key = Key::new(&subject.digest, &request).to_hex();
        let key = self.key(&plan, &truth_key);
        if let Some(finished) = self.folder.finished(stem, &key) {
            self.progress.repeated(format!("{place} is there"));
            return Ok(End::Finished(Box::new(finished)));
        }
        let truth = match self.truths.get(&self.subjects, cell.subject, &request, &mut self.progress) {
            Ok(truth) => truth,
            Err(TracerError::Cancelled) => return Ok(End::Interrupted),
            Err(error) => return Err(Failure::work(error.to_string())),
        };
        self.progress.stage(place.to_owned());
        let measured = measure(&self.gpu, plan, &subject.scene, &subject.camera, self.args.repeat)?;
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

    fn plan(&self, cell: &Cell) -> Result<Plan, Failure> {
        let request = Request {
            format: Some(cell.format.clone()),
            encoding: Some(cell.encoding.clone()),
            tracer: self.args.tracer.clone(),
            resolution: Some(cell.resolution),
            output: cell.effect.image(&self.pipeline).map(str::to_owned),
            filters_float32: self.gpu.filters_float32(),
            ..Request::image(self.args.size[0], self.args.size[1])
        };
        let facts = &self.subjects[cell.subject].facts;
        voxlume::plan(&self.pipeline, facts, self.registry, &request).map_err(Failure::from)
    }

    /// Hash of everything that decides a cell: the program, the device, the reference, and the plan with its shaders.
    fn key(&self, plan: &Plan, truth_key: &str) -> String {
        let device = devices::describe(&self.gpu.info);
        let Plan { format, encoding, grid, screen, passes, resources, shaders, .. } = plan;
        let mut hash = blake3::Hasher::new();
        let mut part = |text: &str| {
            hash.update(&(text.len() as u64).to_le_bytes());
            hash.update(text.as_bytes());
        };
        part(concat!("cell 1 of voxlume ", env!("CARGO_PKG_VERSION")));
        part(&format!("{device:?} {}", self.args.repeat));
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
            width: self.args.size[0],
            height: self.args.size[1],
            outcome,
        }
    }

    fn write(&mut self, results: &Results, pictures: &[(usize, Pictures)]) -> Result<(), Failure> {
        self.progress.stage("writing the report".into());
        let mut strips = Vec::new();
        for (row, pictures) in pictures {
            strips.push(self.folder.strip(*row, pictures)?);
        }
        let [width, height] = self.args.size;
        let subtitle = format!(
            "{width} × {height} pixels; reference of {} samples a pixel; medians of {} frames",
            self.args.spp, self.args.repeat
        );
        let json = results.to_json().map_err(|error| Failure::work(error.to_string()))?;
        let html = page(results, &strips, &utc_now(), &subtitle);
        self.folder.write(vec![("results.json", json), ("results.csv", csv(results)), ("report.html", html)])
    }
}
