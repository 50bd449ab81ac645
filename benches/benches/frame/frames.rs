//! Scenes × formats × tracers × grids × sizes.

use clap::ValueEnum;
use voxlume_benches::table;

use crate::arguments::{Arguments, Change, format_names, or, scene, tracer_names};
use crate::error::{self, rmse};
use crate::scenes;
use crate::timed::{Timer, heads};

/// Prints the table.
pub fn table(timer: &Timer, arguments: &Arguments) -> Result<(), String> {
    let changes = or(&arguments.changes, Change::value_variants());
    let formats = or(&arguments.formats, &format_names());
    let tracers = or(&arguments.tracers, &tracer_names());
    let resolutions = or(&arguments.resolutions, &[128]);
    let sizes = or(&arguments.sizes, &[[320, 180]]);
    if arguments.errors {
        error::forget()?;
    }
    let mut numbers = heads(&changes);
    numbers.extend(arguments.errors.then(|| "RMSE".to_owned()));
    table::head(&["scene", "format", "tracer", "grid", "pixels"].map(str::to_owned), &numbers);
    let mut absent = Vec::new();
    for path in or(&arguments.scenes, &[scene("cornell")?, scene("sponza_lite")?]) {
        if !path.is_file() {
            absent.push(format!("skipped: there is no {}", path.display()));
            continue;
        }
        let scene = scenes::load(&path)?;
        for &resolution in &resolutions {
            for &size in &sizes {
                for tracer in &tracers {
                    for format in &formats {
                        let request = timer.request(format, tracer, resolution, size);
                        // Without volumes all formats are the same frame.
                        let reads_format = timer.reads_format(&scene, &request).unwrap_or(true);
                        let mut cells = vec![
                            scene.name.clone(),
                            if reads_format { format.clone() } else { "any".to_owned() },
                            tracer.clone(),
                            format!("{resolution}³"),
                            format!("{}x{}", size[0], size[1]),
                        ];
                        eprintln!("{}", cells.join(" "));
                        match timer.row(&scene, &request, &changes) {
                            Ok(times) => cells.extend(times.iter().map(ToString::to_string)),
                            Err(message) => {
                                cells.push(format!("refused: {}", first_line(&message)));
                                cells.resize(5 + heads(&changes).len(), "–".into());
                            }
                        }
                        if arguments.errors {
                            cells.push(match rmse(timer, &path, format, tracer, resolution, size) {
                                Ok(error) => format!("{error:.4}"),
                                Err(message) => first_line(&message),
                            });
                        }
                        table::row(&cells);
                        if !reads_format {
                            break;
                        }
                    }
                }
            }
        }
    }
    for line in absent {
        println!("\n{line}");
    }
    Ok(())
}

/// Of a message, for a cell.
pub fn first_line(message: &str) -> String {
    message.lines().next().unwrap_or_default().to_owned()
}
