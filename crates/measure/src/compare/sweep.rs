//! The sweep: cell after cell.

use std::sync::atomic::{AtomicBool, Ordering};

use voxlume::{Gpu, Pipeline, Plan, Request, Value};
use voxlume_reference::cache::Key;
use voxlume_reference::{PixelSampling, Reflection};
use voxlume_report::{Outcome, Results, Row, SCHEMA};

use super::Sweep;
use super::cell::{Cell, Cells, Subject, cells};
use super::folder::{Finished, Folder, Pictures};
use super::measure::{image_size, measure};
use super::report::judge;
use super::truth::{Last, References, Truth};
use crate::settings::{Setting, Settings};
use crate::{Error, Progress, describe};

/// What cells need.
struct Run<'a> {
    sweep: &'a Sweep<'a>,
    subjects: Vec<Subject>,
    finest: Setting,
    folder: Folder,
    references: References,
    last: Last,
    gpu: Gpu,
    progress: &'a mut dyn Progress,
    stop: &'a AtomicBool,
}

/// How the image comes about that a cell is held against.
enum Against {
    Traced(Box<voxlume_reference::Request>),
    Rendered(Box<Plan>),
}

/// Runs all cells and writes the report.
pub fn run(sweep: &Sweep<'_>, progress: &mut dyn Progress, stop: &AtomicBool) -> Result<Results, Error> {
    let Cells { subjects, cells, finest } = cells(sweep)?;
    let folder = Folder::new(&sweep.folder)?;
    let gpu = Gpu::open(sweep.settings.adapter.as_deref())?;
    let device = describe(&gpu.info);
    let references = References::new(&folder.cache());
    let last = Last::default();
    let mut run = Run { sweep, subjects, finest, folder, references, last, gpu, progress, stop };

    let mut results = Results { schema: SCHEMA, device, rows: Vec::new() };
    let mut pictures = Vec::new();
    for (number, cell) in cells.iter().enumerate() {
        let interrupted = Error::Interrupted { finished: number, all: cells.len() };
        if stop.load(Ordering::Relaxed) {
            return Err(interrupted);
        }
        let stem = cell.stem(&run.subjects);
        let place = format!("cell {}/{}: {stem}", number + 1, cells.len());
        match run.cell(cell, &stem, &place) {
            Ok(finished) => {
                pictures.push((number, finished.pictures));
                results.rows.push(finished.row);
            }
            // The reference was stopped amid its samples.
            Err(_) if stop.load(Ordering::Relaxed) => return Err(interrupted),
            Err(error) => {
                results.rows.push(run.row(cell, Outcome::Failed { fault: error.to_string() }));
                // Later cells get a device that works.
                if run.gpu.check().is_err() {
                    run.gpu = Gpu::open(sweep.settings.adapter.as_deref())?;
                }
            }
        }
    }
    run.progress.stage("writing the report".into());
    let [width, height] = sweep.settings.size;
    let subtitle = format!(
        "{width} × {height} pixels; reference of {} samples a pixel; medians of {} frames",
        sweep.samples, sweep.repeat
    );
    run.folder.report(&results, &pictures, &sweep.bounds, &subtitle)?;
    Ok(results)
}

impl Run<'_> {
    /// A cell as it lies in the folder, or else made now and put there.
    fn cell(&mut self, cell: &Cell<'_>, stem: &str, place: &str) -> Result<Finished, Error> {
        let plan = self.plan(cell, &cell.setting)?;
        let against = self.against(cell, &plan)?;
        let subject = &self.subjects[cell.subject];
        let truth_key = match &against {
            Against::Traced(request) => Key::new(&subject.digest, request).to_hex(),
            Against::Rendered(plan) => self.key(cell, plan, "rendered"),
        };
        let key = self.key(cell, &plan, &truth_key);
        if let Some(finished) = self.folder.finished(stem, &key) {
            self.progress.repeated(format!("{place} is there"));
            return Ok(finished);
        }
        let size = image_size(&plan);
        let truth = self.last.or_make(&format!("{truth_key} {size:?}"), || match against {
            Against::Traced(request) => {
                self.references.get((cell.subject, subject), &request, size, self.progress, self.stop)
            }
            Against::Rendered(plan) => {
                let measured = measure(&self.gpu, *plan, &subject.scene, &subject.camera, 0)?;
                Ok(Truth::rendered(&measured, cell.effect.shows))
            }
        })?;
        self.progress.stage(place.to_owned());
        let measured = measure(&self.gpu, plan, &subject.scene, &subject.camera, self.sweep.repeat)?;
        let judged = judge(&cell.effect, &measured, truth)?;
        let outcome = Outcome::Measured {
            passes: measured.passes,
            total_ms: measured.total_ms,
            volume_bytes: measured.volume_bytes,
            out_of_range: measured.out_of_range,
            error: judged.errors,
        };
        let reference = format!("{}-{}-reference-{}", subject.label, cell.effect.name, &truth_key[..8]);
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
        Ok(finished)
    }

    fn plan(&self, cell: &Cell<'_>, setting: &Setting) -> Result<Plan, Error> {
        let Settings { registry, pipeline, .. } = self.sweep.settings;
        let output = Some(cell.effect.image.to_owned());
        let request = self.sweep.settings.request(setting, &self.gpu);
        let request = Request { output, set: unfiltered(self.sweep.settings.pipeline), ..request };
        let facts = &self.subjects[cell.subject].facts;
        voxlume::plan(pipeline, facts, registry, &request).map_err(Error::from)
    }

    /// The path tracer's picture of the effect's quantity; without one, the effect in the finest setting.
    fn against(&self, cell: &Cell<'_>, plan: &Plan) -> Result<Against, Error> {
        let Settings { pipeline, size: [width, height], .. } = self.sweep.settings;
        let subject = &self.subjects[cell.subject];
        let quantity = cell.effect.quantity(
            pipeline,
            plan,
            &subject.scene,
            self.sweep.settings.registry.kinds.bounces(pipeline),
        )?;
        let Some(quantity) = quantity else {
            return Ok(Against::Rendered(Box::new(self.plan(cell, &self.finest)?)));
        };
        Ok(Against::Traced(Box::new(voxlume_reference::Request {
            camera: subject.camera.clone(),
            width,
            height,
            samples: self.sweep.samples,
            seed: 0,
            sampling: PixelSampling::Centre,
            quantity,
            reflection: Reflection::Gltf,
        })))
    }

    /// Hash of everything that decides a cell: the program, the device, the scene, what it is held against, and the plan with
    /// its shaders.
    fn key(&self, cell: &Cell<'_>, plan: &Plan, truth_key: &str) -> String {
        let device = describe(&self.gpu.info);
        let Subject { digest, camera, .. } = &self.subjects[cell.subject];
        let Plan { format, encoding, grid, screen, passes, resources, shaders, .. } = plan;
        let mut hash = blake3::Hasher::new();
        let mut part = |text: &str| {
            hash.update(&(text.len() as u64).to_le_bytes());
            hash.update(text.as_bytes());
        };
        part(concat!("cell 2 of voxlume ", env!("CARGO_PKG_VERSION")));
        part(&format!("{device:?} {} {digest:?} {camera:?} {:?}", self.sweep.repeat, cell.effect.shows));
        part(truth_key);
        part(&format!("{format} {encoding:?} {grid:?} {screen:?} {passes:?} {resources:?}"));
        shaders.iter().for_each(|shader| part(&shader.wgsl));
        hash.finalize().to_hex().to_string()
    }

    fn row(&self, cell: &Cell<'_>, outcome: Outcome) -> Row {
        let Setting { format, encoding, tracer, resolution, scale } = cell.setting.clone();
        Row {
            scene: self.subjects[cell.subject].label.clone(),
            effect: cell.effect.name.to_owned(),
            format,
            encoding,
            tracer,
            resolution,
            scale,
            width: self.sweep.settings.size[0],
            height: self.sweep.settings.size[1],
            held_against: cell.effect.reference.is_none().then(|| self.finest.to_string()),
            outcome,
        }
    }
}

/// The reference looks textures up at pixels' middles: so does what is held against it.
fn unfiltered(pipeline: &Pipeline) -> Vec<(String, String, Value)> {
    let draws = pipeline.passes.iter().filter(|entry| entry.run.value == "gbuffer");
    draws.map(|entry| (entry.name.clone(), "textures".into(), Value::Word("at_centre".into()))).collect()
}
