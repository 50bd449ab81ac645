//! Lines of Markdown.

use voxlume::Scene;
use voxlume_benches::table;

use crate::arguments::Arguments;
use crate::measure::Cell;

/// The table's head.
pub fn head(arguments: &Arguments) {
    let words = ["scene", "triangles", "grid", "separability", "attributes"].map(str::to_owned);
    let rates = ["M triangles/s", "MiB"].map(str::to_owned);
    table::head(&words, &[&arguments.methods[..], &rates].concat());
}

/// One row, its fastest cells in bold; triangles a second and bytes are those of the fastest.
pub fn row(name: &str, scene: &Scene, resolution: u32, separability: &str, attributes: bool, cells: &[Cell]) {
    let triangles: usize = scene.instances.iter().map(|i| scene.meshes[i.mesh].triangles.len()).sum();
    let Some(best) = cells.iter().min_by(|a, b| a.milliseconds.total_cmp(&b.milliseconds)) else { return };
    let mut row = vec![
        name.to_owned(),
        triangles.to_string(),
        format!("{resolution}³"),
        separability.to_owned(),
        if attributes { "yes" } else { "no" }.to_owned(),
    ];
    row.extend(cells.iter().map(|cell| {
        let time = format!("{:.2}", cell.milliseconds);
        if cell.milliseconds <= best.milliseconds { format!("**{time}**") } else { time }
    }));
    row.push(format!("{:.1}", triangles as f64 / best.milliseconds / 1e3));
    row.push(format!("{:.1}", best.bytes as f64 / f64::from(1 << 20)));
    table::row(&row);
}
