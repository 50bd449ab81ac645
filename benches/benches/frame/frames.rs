//! Scenes × formats × tracers × grids × sizes.

use clap::ValueEnum;
use voxlume::Scene;
use voxlume_benches::table;

use crate::arguments::{Arguments, Change, format_names, or, scene, tracer_names};
use crate::error::{self, rmse};
use crate::scenes;
use crate::timed::{Setting, Timer, heads};

/// Prints the table.
pub fn table(timer: &Timer, arguments: &Arguments) -> Result<(), String> {
    let changes = or(&arguments.changes, Change::value_variants());
    let formats = or(&arguments.formats, &format_names());
    let tracers = or(&arguments.tracers, &tracer_names());
    let resolutions = or(&arguments.resolutions, &[128]);
    let sizes = or(&arguments.sizes, &[[320, 180]]);
    let mut numbers = heads(&changes);
    if arguments.errors {
        error::forget()?;
        numbers.push("RMSE".to_owned());
    }
    table::head(&["scene", "format", "tracer", "grid", "pixels"].map(str::to_owned), &numbers);
    let mut absent = Vec::new();
    for path in or(&arguments.scenes, &[scene("cornell")?, scene("sponza_lite")?]) {
        if !path.is_file() {
            absent.push(path);
            continue;
        }
        let scene = scenes::load(&path)?;
        for &resolution in &resolutions {
            for &size in &sizes {
                for tracer in &tracers {
                    for format in &formats {
                        let setting = Setting { format, tracer, resolution, size };
                        // Without volumes all formats are the same frame.
                        let reads_format = timer.reads_format(&scene, &setting).unwrap_or(true);
                        let format = if reads_format { format } else { "any" };
                        let mut row = cells(timer, &scene, &setting, format, &changes);
                        if arguments.errors {
                            let error = rmse(timer, &path, &setting);
                            row.push(
                                error.map_or_else(|message| first_line(&message), |e| format!("{e:.4}")),
                            );
                        }
                        table::row(&row);
                        if !reads_format {
                            break;
                        }
                    }
                }
            }
        }
    }
    for path in absent {
        println!("\nskipped: there is no {}", path.display());
    }
    Ok(())
}

/// A row's words and times.
fn cells(
    timer: &Timer,
    scene: &Scene,
    setting: &Setting<'_>,
    format: &str,
    changes: &[Change],
) -> Vec<String> {
    let Setting { tracer, resolution, size: [width, height], .. } = *setting;
    let (grid, pixels) = (format!("{resolution}³"), format!("{width}x{height}"));
    let mut cells = vec![scene.name.clone(), format.to_owned(), tracer.to_owned(), grid, pixels];
    eprintln!("{}", cells.join(" "));
    let words = cells.len();
    match timer.row(scene, &timer.request(setting), changes) {
        Ok(times) => cells.extend(times.iter().map(ToString::to_string)),
        Err(message) => cells.push(format!("refused: {}", first_line(&message))),
    }
    cells.resize(words + heads(changes).len(), "–".to_owned());
    cells
}

/// Of a message, for a cell.
pub fn first_line(message: &str) -> String {
    message.lines().next().unwrap_or_default().to_owned()
}
