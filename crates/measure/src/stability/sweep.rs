//! Case after case.

use std::sync::atomic::{AtomicBool, Ordering};

use voxlume::{Fault, Faults, Gpu};
use voxlume_fault::suggest;
use voxlume_report::{Stability, StabilityRow};

use super::bench::{Bench, scene};
use super::cases::{CASES, Case, Measure, REFUSED};
use super::figure::Figures;
use super::{Ran, Suite, misses};
use crate::settings::Setting;
use crate::{Error, Progress, describe};

/// One case in one setting.
struct Cell {
    case: &'static Case,
    setting: Setting,
}

/// Every case.
pub fn all() -> impl Iterator<Item = &'static Case> {
    CASES.iter().chain(&REFUSED)
}

/// Runs the cases asked for, and tells of them.
pub fn run(suite: &Suite<'_>, progress: &mut dyn Progress, stop: &AtomicBool) -> Result<Ran, Error> {
    let cells = cells(suite)?;
    let mut gpu = Gpu::open(suite.settings.adapter.as_deref())?;
    let mut stability = Stability::new(describe(&gpu.info));
    let mut done = 0;
    for (number, cell) in cells.iter().enumerate() {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        let place = format!("cell {}/{}: {} {}", number + 1, cells.len(), cell.case.name, cell.setting);
        if number == 0 {
            progress.stage(place);
        } else {
            progress.repeated(place);
        }
        let figures = measure(cell, suite, &gpu);
        // What is wrong with the shaders mostly shows at once; no need to tell it of every cell.
        let figures = match figures {
            Err(failure @ Error::Input(_)) if done == 0 => return Err(failure),
            figures => figures,
        };
        stability.rows.extend(rows(cell, figures));
        done += 1;
        // Later cells get a device that works.
        if gpu.check().is_err() {
            gpu = Gpu::open(suite.settings.adapter.as_deref())?;
        }
    }
    Ok(Ran { stability, finished: done, all: cells.len() })
}

/// What is to be run, checked.
fn cells(suite: &Suite<'_>) -> Result<Vec<Cell>, Faults> {
    let mut faults = Faults::default();
    let names: Vec<&str> = all().map(|case| case.name).collect();
    for case in suite.cases.iter().filter(|case| !names.contains(&case.as_str())) {
        let label = suggest(case, names.iter().copied());
        faults.push(Fault::new(format!("unknown case `{case}`")).note(label));
    }
    let variants = suite.settings.variants(&mut faults);
    let asked = suite.settings.resolutions(&mut faults);
    let mut cells = Vec::new();
    for case in
        all().filter(|case| suite.cases.is_empty() || suite.cases.iter().any(|name| name == case.name))
    {
        let settings = match case.measure {
            Measure::Loaded(_) => {
                let [format, encoding, tracer] = ["-"; 3].map(str::to_owned);
                vec![Setting { format, encoding, tracer, resolution: 0, scale: None }]
            }
            Measure::Rendered(_) => {
                Setting::each(&variants, if asked.is_empty() { case.resolutions } else { &asked })
            }
        };
        cells.extend(settings.into_iter().map(|setting| Cell { case, setting }));
    }
    faults.into_result(cells)
}

fn measure(cell: &Cell, suite: &Suite<'_>, gpu: &Gpu) -> Figures {
    let Cell { case, setting } = cell;
    match case.measure {
        Measure::Loaded(measure) => measure(case.scene),
        Measure::Rendered(measure) => {
            let bench = Bench { settings: &suite.settings, setting: setting.clone(), gpu };
            measure(&bench, &scene(case.scene)?)
        }
    }
}

fn rows(cell: &Cell, figures: Figures) -> Vec<StabilityRow> {
    let row = |figure: String, value: f64, bound, pass, at| StabilityRow {
        case: cell.case.name.into(),
        format: cell.setting.format.clone(),
        encoding: cell.setting.encoding.clone(),
        tracer: cell.setting.tracer.clone(),
        resolution: cell.setting.resolution,
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
