//! Case after case.

use voxlume::{Fault, Faults, Gpu, Grid, Pipeline};
use voxlume_fault::suggest;
use voxlume_report::{Stability, StabilityRow, stability_page, utc_now};

use super::Args;
use super::bench::{Bench, scene};
use super::cases::{CASES, Case, Measure, REFUSED};
use super::figure::Figures;
use super::misses;
use crate::failure::Failure;
use crate::outfile::{self, OutFile};
use crate::progress::Progress;
use crate::table::Table;
use crate::words::words;
use crate::{Registry, devices, interrupt, pipeline};

/// One case in one setting.
struct Cell {
    case: &'static Case,
    format: String,
    encoding: String,
    resolution: u32,
}

fn all() -> impl Iterator<Item = &'static Case> {
    CASES.iter().chain(&REFUSED)
}

/// Lists the cases.
pub fn list() -> Result<(), Failure> {
    let mut table = Table::new(["case", "what should hold", "scene"]);
    for case in all() {
        table.row([case.name.into(), case.property.into(), case.scene.0.into()]);
    }
    crate::print(&table.to_string())
}

/// Runs the cases asked for, and tells of them.
pub fn run(args: &Args, registry: &Registry) -> Result<(), Failure> {
    interrupt::wish();
    let cells = cells(args, registry)?;
    let json = args.json.as_deref().map(OutFile::new).transpose()?;
    let html = args.html.as_deref().map(OutFile::new).transpose()?;
    outfile::distinct(json.iter().chain(&html))?;
    let pipeline = pipeline::load("gi")?;
    let mut gpu = Gpu::open(args.adapter.as_deref())?;
    let mut stability = Stability::new(devices::describe(&gpu.info));
    let mut progress = Progress::new();
    let mut done = 0;
    for (number, cell) in cells.iter().enumerate() {
        if interrupt::wished() {
            break;
        }
        let Cell { case, format, encoding, resolution } = cell;
        let place =
            format!("cell {}/{}: {} {format} {encoding} {resolution}³", number + 1, cells.len(), case.name);
        if number == 0 {
            progress.stage(place);
        } else {
            progress.repeated(place);
        }
        let figures = measure(cell, registry, &gpu, &pipeline, args.size);
        // What is wrong with the shaders mostly shows at once; no need to tell it of every cell.
        let figures = match figures {
            Err(failure @ Failure::Input(_)) if done == 0 => return Err(failure),
            figures => figures,
        };
        stability.rows.extend(rows(cell, figures));
        done += 1;
        // Later cells get a device that works.
        if gpu.check().is_err() {
            gpu = Gpu::open(args.adapter.as_deref())?;
        }
    }
    drop(progress);
    let mut files = Vec::new();
    if let Some(file) = json {
        let text = stability.to_json().map_err(|error| Failure::work(error.to_string()))?;
        files.push((file, text.into_bytes()));
    }
    if let Some(file) = html {
        files.push((file, stability_page(&stability, &utc_now()).into_bytes()));
    }
    crate::print(&table(&stability))?;
    outfile::write(&files)?;
    let failed = stability.rows.iter().filter(|row| row.verdict() == "FAIL").count();
    match (done == cells.len(), failed) {
        (false, _) => {
            Err(Failure::work(format!("interrupted: {done} of {} cells are finished", cells.len())))
        }
        (true, 0) => Ok(()),
        (true, _) => Err(Failure::work(format!(
            "{failed} of {} figures are out of their bounds",
            stability.rows.len()
        ))),
    }
}

/// What is to be run, checked.
fn cells(args: &Args, registry: &Registry) -> Result<Vec<Cell>, Faults> {
    let mut faults = Faults::default();
    let names: Vec<&str> = all().map(|case| case.name).collect();
    for case in args.cases.iter().filter(|case| !names.contains(&case.as_str())) {
        let label = suggest(case, names.iter().copied());
        faults.push(Fault::new(format!("unknown case `{case}`")).note(label));
    }
    let known: Vec<&str> = registry.formats.iter().map(|format| format.name()).collect();
    let formats = words("storage format", &args.formats, &known, &mut faults);
    let known: Vec<&str> = registry.encodings.iter().map(|encoding| encoding.name).collect();
    let encodings = words("encoding", &args.encodings, &known, &mut faults);
    for resolution in args.resolutions.iter().filter(|resolution| !Grid::RESOLUTIONS.contains(resolution)) {
        let range = Grid::RESOLUTIONS;
        let fault = Fault::new(format!("a grid of {resolution} × {resolution} × {resolution} voxels"));
        faults.push(fault.note(format!("each side: {} to {}", range.start(), range.end())));
    }
    let mut cells = Vec::new();
    for case in all().filter(|case| args.cases.is_empty() || args.cases.iter().any(|name| name == case.name))
    {
        if let Measure::Loaded(_) = case.measure {
            cells.push(Cell { case, format: "-".into(), encoding: "-".into(), resolution: 0 });
            continue;
        }
        let resolutions = if args.resolutions.is_empty() { case.resolutions } else { &args.resolutions };
        for format in &formats {
            for encoding in &encodings {
                cells.extend(resolutions.iter().map(|&resolution| Cell {
                    case,
                    format: format.clone(),
                    encoding: encoding.clone(),
                    resolution,
                }));
            }
        }
    }
    faults.into_result(cells)
}

fn measure(cell: &Cell, registry: &Registry, gpu: &Gpu, pipeline: &Pipeline, size: [u32; 2]) -> Figures {
    let Cell { case, format, encoding, resolution } = cell;
    match case.measure {
        Measure::Loaded(measure) => measure(case.scene),
        Measure::Rendered(measure) => {
            let (format, encoding) = (format.clone(), encoding.clone());
            let bench = Bench { registry, gpu, pipeline, format, encoding, resolution: *resolution, size };
            measure(&bench, &scene(case.scene)?)
        }
    }
}

fn rows(cell: &Cell, figures: Figures) -> Vec<StabilityRow> {
    let row = |figure: String, value: f64, bound, pass, at| StabilityRow {
        case: cell.case.name.into(),
        format: cell.format.clone(),
        encoding: cell.encoding.clone(),
        resolution: cell.resolution,
        figure,
        value,
        bound,
        pass,
        reason: None,
        at,
    };
    match figures {
        Ok(figures) => figures
            .into_iter()
            .map(|figure| {
                let pass = figure.pass();
                let row = row(figure.name, figure.value, figure.bound, pass, figure.at);
                let reason = misses::reason(&row).filter(|_| !pass).map(str::to_owned);
                StabilityRow { reason, ..row }
            })
            .collect(),
        // It counts as a miss that nobody knows of.
        Err(failure) => {
            let message = failure.to_string();
            let line = message.lines().next().unwrap_or_default();
            vec![row(format!("failed: {line}"), f64::NAN, None, false, None)]
        }
    }
}

fn table(stability: &Stability) -> String {
    let mut table = Table::new(["case", "format", "encoding", "figure", "N", "value", "bound", "verdict"])
        .numbers_from(4);
    for row in &stability.rows {
        let number = |value: f64| format!("{value:.3e}");
        table.row([
            row.case.clone(),
            row.format.clone(),
            row.encoding.clone(),
            row.figure.clone(),
            row.resolution.to_string(),
            number(row.value),
            row.bound.map_or_else(|| "-".into(), number),
            row.verdict().into(),
        ]);
    }
    table.to_string()
}
