//! Draws what each format shows of a wall from every direction, level by level, as measured on the device:
//! `cargo run --release -p voxlume-conformance --example polar -- book/src/formats`

use std::error::Error;
use std::f64::consts::PI;
use std::fmt::Write;
use std::path::Path;

use glam::{DVec3, UVec3};
use voxlume::{Choices, Encoding, Formats, Gpu, Library};
use voxlume_conformance::{Bench, Content, Probe, SIDE, Voxel};

/// Directions in a circle.
const STEPS: usize = 360;
/// Pixels of one unit of radiance.
const UNIT: f64 = 130.0;
const COLOURS: [&str; 4] = ["#b35806", "#1b7837", "#2166ac", "#762a83"];

/// A wall of radiance 1 in the middle of the grid, and cells of each level that lie in it.
struct Wall {
    title: &'static str,
    normal: DVec3,
    content: Content,
    cell: fn(u32) -> UVec3,
}

fn walls() -> [Wall; 2] {
    let slant = DVec3::new(1.0, 1.0, 0.0).normalize();
    let diagonal = Content::of(SIDE, |cell| {
        // Every voxel that the plane x + y = 7.5 crosses, in halves of a voxel.
        let on = (6..=7).contains(&(cell.x + cell.y));
        on.then(|| Voxel::facing(cell, slant, DVec3::ONE))
    });
    [
        Wall {
            title: "along the grid",
            normal: DVec3::X,
            content: Content::wall(SIDE, 0, 2, true, DVec3::ONE),
            cell: |level| UVec3::new(2, 3, 3) / (1 << level),
        },
        Wall {
            title: "at 45°",
            normal: slant,
            content: diagonal,
            cell: |level| UVec3::new(4, 3, 3) / (1 << level),
        },
    ]
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("say into which folder")?;
    let gpu = Gpu::open(None)?;
    let library = Library::builtin();
    for format in Formats::builtin().iter() {
        let mut bench = Bench::new(&gpu, format, &Choices::default(), &library, Encoding::RGBA16FLOAT, SIDE)?;
        let mut svg = String::from(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 400\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"720\" height=\"400\" fill=\"#fff\"/>\n",
        );
        for (panel, wall) in walls().iter().enumerate() {
            draw(&mut svg, &mut bench, wall, 180.0 + 360.0 * panel as f64)?;
        }
        for (level, colour) in COLOURS.iter().enumerate() {
            let x = 150 + 100 * level;
            writeln!(
                svg,
                "<path d=\"M{x} 384h24\" stroke=\"{colour}\" stroke-width=\"2\"/><text x=\"{}\" y=\"388\">level {level}</text>",
                x + 30
            )?;
        }
        writeln!(
            svg,
            "<path d=\"M550 384h24\" stroke=\"#888\" stroke-dasharray=\"4 3\"/><text x=\"580\" y=\"388\">the surface</text>\n</svg>"
        )?;
        let file = Path::new(&folder).join(format!("{}-polar.svg", format.name()));
        std::fs::write(&file, svg)?;
        println!("{} on {}", file.display(), gpu.info.name);
    }
    Ok(())
}

/// One panel: premultiplied radiance over the direction that the observer is in.
fn draw(svg: &mut String, bench: &mut Bench<'_>, wall: &Wall, middle: f64) -> Result<(), Box<dyn Error>> {
    let observers: Vec<DVec3> = (0..STEPS)
        .map(|i| (2.0 * PI * i as f64 / STEPS as f64).sin_cos())
        .map(|(sin, cos)| DVec3::new(cos, sin, 0.0))
        .collect();
    let place = |observer: &DVec3, value: f64| {
        (middle + observer.x * value * UNIT, 200.0 - observer.y * value * UNIT)
    };
    writeln!(svg, "<text x=\"{middle}\" y=\"24\" text-anchor=\"middle\">a wall {}</text>", wall.title)?;
    for radius in [0.5, 1.0] {
        writeln!(
            svg,
            "<circle cx=\"{middle}\" cy=\"200\" r=\"{}\" fill=\"none\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{}\" fill=\"#888\" font-size=\"10\">{radius}</text>",
            radius * UNIT,
            middle + 3.0,
            197.0 - radius * UNIT
        )?;
    }
    // The area of the wall's piece in one cell, as its observer sees it: |n|₁·max(n·ω, 0), at most all of the cell.
    let area = wall.normal.abs().element_sum();
    let exact: Vec<f64> = observers.iter().map(|o| (area * o.dot(wall.normal)).clamp(0.0, 1.0)).collect();
    let mut curves = vec![(exact, "#888", "4 3")];
    for level in 0..bench.levels() {
        let probe = |o: &DVec3| Probe::at((wall.cell)(level), level, SIDE, -*o);
        let probes: Vec<Probe> = observers.iter().map(probe).collect();
        let values = bench.run(&wall.content, &probes)?.iter().map(|value| value.x).collect();
        curves.push((values, COLOURS[level as usize], "none"));
    }
    for (values, colour, dashes) in curves {
        let points: Vec<String> = observers
            .iter()
            .zip(values)
            .map(|(observer, value)| place(observer, value))
            .map(|(x, y)| format!("{x:.1},{y:.1}"))
            .collect();
        writeln!(
            svg,
            "<polygon points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\" stroke-dasharray=\"{dashes}\"/>",
            points.join(" ")
        )?;
    }
    Ok(())
}
