//! How a frame's time grows.

use std::borrow::Cow;

use voxlume::{Request, Scene};
use voxlume_benches::table::{self, digits};

use crate::arguments::{Arguments, Change, Table, format_names, or, scene, tracer_names};
use crate::frames::first_line;
use crate::scenes::{self, Room};
use crate::timed::{Setting, Time, Timer, heads};

/// What grows, and how far.
pub struct Growth {
    head: &'static str,
    steps: &'static [u32],
    case: for<'a> fn(&'a Scene, Request, u32) -> Result<Case<'a>, String>,
}

/// A step: how it is called, and what is rendered.
type Case<'a> = (String, Cow<'a, Scene>, Request);

impl Growth {
    /// What a table shows; `None` of the one that shows none.
    pub fn of(table: Table) -> Option<Growth> {
        Some(match table {
            Table::Frames => return None,
            Table::Resolution => Growth { head: "grid", steps: &[64, 128, 256, 512], case: resolution },
            Table::Pixels => Growth { head: "pixels", steps: &[1, 2, 4], case: pixels },
            Table::Lights => Growth { head: "lamps", steps: &[1, 2, 4, 8, 16], case: lamps },
            Table::Triangles => {
                Growth { head: "triangles", steps: &[100, 1_000, 10_000, 100_000], case: triangles }
            }
        })
    }

    /// Prints the table.
    pub fn table(&self, timer: &Timer, arguments: &Arguments) -> Result<(), String> {
        let changes = or(&arguments.changes, &[Change::Everything, Change::Camera]);
        let path = or(&arguments.scenes, &[scene("cornell")?]).remove(0);
        let scene = scenes::load(&path)?;
        let grid = or(&arguments.resolutions, &[128])[0];
        let size = or(&arguments.sizes, &[[320, 180]])[0];
        let format = or(&arguments.formats, &format_names()).remove(0);
        let still = [("grid", format!("{grid}³")), ("pixels", format!("{}x{}", size[0], size[1]))];
        let still = still.into_iter().filter(|(what, _)| *what != self.head).map(|(_, value)| value);
        let still: Vec<String> = [scene.name.clone(), format.clone()].into_iter().chain(still).collect();
        println!("Growth with the {}: {}\n", self.head, still.join(", "));
        table::head(&["tracer", self.head].map(str::to_owned), &heads(&changes));
        let mut refusals = Vec::new();
        for tracer in or(&arguments.tracers, &tracer_names()) {
            let mut before: Option<Vec<Time>> = None;
            for step in self.steps {
                let setting = Setting { format: &format, tracer: &tracer, resolution: grid, size };
                let request = timer.request(&setting);
                let (label, scene, request) = (self.case)(&scene, request, *step)?;
                eprintln!("{tracer}, {}: {label}", self.head);
                let times = match timer.row(&scene, &request, &changes) {
                    Ok(times) => times,
                    Err(message) => {
                        refusals.push(format!("{tracer} stops at {label}: {}", first_line(&message)));
                        break;
                    }
                };
                let cells = times.iter().enumerate().map(|(column, time)| match &before {
                    Some(before) if before[column].median > 0.0 => {
                        format!("{time} (×{})", digits(time.median / before[column].median))
                    }
                    _ => time.to_string(),
                });
                let cells: Vec<String> = [tracer.clone(), label].into_iter().chain(cells).collect();
                table::row(&cells);
                before = Some(times);
            }
        }
        for line in refusals {
            println!("\n{line}");
        }
        Ok(())
    }
}

fn resolution(scene: &Scene, request: Request, step: u32) -> Result<Case<'_>, String> {
    Ok((format!("{step}³"), Cow::Borrowed(scene), Request { resolution: Some(step), ..request }))
}

/// Both sides grow alike, so that the same is seen.
fn pixels(scene: &Scene, request: Request, step: u32) -> Result<Case<'_>, String> {
    let screen = request.screen.map(|side| (f64::from(side) * f64::from(step).sqrt()).round() as u32);
    Ok((format!("{}x{}", screen[0], screen[1]), Cow::Borrowed(scene), Request { screen, ..request }))
}

fn lamps(scene: &Scene, request: Request, step: u32) -> Result<Case<'_>, String> {
    let mut grown = scene.clone();
    Room::of(scene)?.add_lamps(&mut grown, step);
    Ok((step.to_string(), Cow::Owned(grown), request))
}

fn triangles(scene: &Scene, request: Request, step: u32) -> Result<Case<'_>, String> {
    // 5 : 4 rings to sides or near it, and 2 triangles for each quad.
    let sides = [5, 20, 50, 200].into_iter().rfind(|sides| 2 * sides * sides <= step).unwrap_or(5);
    let mut grown = scene.clone();
    Room::of(scene)?.add_object(&mut grown, [step / 2 / sides, sides], false);
    Ok((step.to_string(), Cow::Owned(grown), request))
}
