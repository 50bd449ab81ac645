//! Lines of Markdown.

use voxlume::Scene;

use crate::arguments::Arguments;
use crate::measure::Cell;

/// The table's head.
pub fn head(arguments: &Arguments) {
    let methods = arguments.methods.join(" | ");
    println!("| scene | triangles | grid | separability | attributes | {methods} | M triangles/s | MiB |");
    println!("|---|--:|--:|---|---|{}--:|--:|", "--:|".repeat(arguments.methods.len()));
}

/// One row, its fastest cells in bold; triangles a second and bytes are those of the fastest.
pub fn row(name: &str, scene: &Scene, resolution: u32, separability: &str, attributes: bool, cells: &[Cell]) {
    let triangles: usize = scene.instances.iter().map(|i| scene.meshes[i.mesh].triangles.len()).sum();
    let Some(best) = cells.iter().min_by(|a, b| a.milliseconds.total_cmp(&b.milliseconds)) else { return };
    let times: Vec<String> = cells
        .iter()
        .map(|cell| {
            let time = format!("{:.2}", cell.milliseconds);
            if cell.milliseconds <= best.milliseconds { format!("**{time}**") } else { time }
        })
        .collect();
    println!(
        "| {name} | {triangles} | {resolution}³ | {separability} | {} | {} | {:.1} | {:.1} |",
        if attributes { "yes" } else { "no" },
        times.join(" | "),
        triangles as f64 / best.milliseconds / 1e3,
        best.bytes as f64 / f64::from(1 << 20)
    );
}
